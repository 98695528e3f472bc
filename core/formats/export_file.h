// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/formats/export_source.h"
#include "core/formats/read_back.h"

namespace toile {

/// The files of an export.
struct Exported {
    std::vector<std::filesystem::path> files;  ///< the requested one first
    std::optional<ReadBack> readBack{};        ///< none for a format without `readBack`
    std::vector<Wording> notes{};              ///< on content that the format cannot hold
};

/// Writes an export in the format of its file name (`formatOf`), with its additional files. The
/// files are created, read back and compared before they replace existing ones.
/// @param progress  if cancelled before the files are written, no file is written
/// Errors: UnknownFormat, FormatNotBuilt, those of the writer, NotReadBack, FileUnwritable,
/// Cancelled.
Result<Exported> exportFile(const std::filesystem::path& path, const ExportSource& source,
                            const Progress& progress = {});

/// The path of a file of an export. @param beside  of an ExportedFile
std::filesystem::path exportedPath(const std::filesystem::path& path, const std::string& beside);

}  // namespace toile
