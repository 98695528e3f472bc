// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/export/export_source.h"
#include "core/export/read_back.h"

namespace toile {

/// What has been written.
struct Exported {
    std::vector<std::filesystem::path> files;  ///< the one asked for first
    std::optional<ReadBack> readBack{};        ///< none of a format without `readBack`
};

/// Writes an export in the format of its ending (`formatOf`), and what belongs beside it: made,
/// read back and compared, and only then put in the place of what was there.
/// @param progress  cancelled before the files are written, none is
/// Errors: UnknownFormat, FormatNotBuilt, those of the writer, NotReadBack, FileUnwritable,
/// Cancelled.
Result<Exported> exportFile(const std::filesystem::path& path, const ExportSource& source,
                            const Progress& progress = {});

/// Where a file of an export goes. @param beside  of an ExportedFile
std::filesystem::path exportedPath(const std::filesystem::path& path, const std::string& beside);

}  // namespace toile
