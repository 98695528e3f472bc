// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/pattern_file.h"

namespace toile {

enum class PatternFileKind { Dxf, Svg, GarmentCode };

/// Kind of a pattern file by its extension, in any case; none for other extensions.
std::optional<PatternFileKind> patternFileKind(const std::filesystem::path& path);

/// Reads a pattern from memory.
/// @param name  of the file, for the error
/// @param unit  of its coordinates, if the user has set it
/// Errors: MalformedFile, NoGeometry.
Result<PatternFile> readPattern(std::string_view bytes, PatternFileKind kind,
                                const std::string& name,
                                std::optional<FileUnit> unit = std::nullopt);

/// Reads a pattern file; the extension gives its kind.
/// @param unit  of its coordinates, if the user has set it
/// Errors: UnknownFormat, FileUnreadable, MalformedFile, NoGeometry, with the file's name.
Result<PatternFile> readPatternFile(const std::filesystem::path& path,
                                    std::optional<FileUnit> unit = std::nullopt);

}  // namespace toile
