// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/reading/pattern_file.h"

namespace toile {

enum class PatternFileKind { Dxf, Svg, GarmentCode };

/// By the ending, in any case; none where it is none of a pattern.
std::optional<PatternFileKind> patternFileKind(const std::filesystem::path& path);

/// A pattern in memory.
/// @param name  of the file, for the error
/// @param unit  of its coordinates, where a person has said it
/// Errors: MalformedFile, NoGeometry.
Result<PatternFile> readPattern(std::string_view bytes, PatternFileKind kind,
                                const std::string& name,
                                std::optional<FileUnit> unit = std::nullopt);

/// Reads a pattern by its ending.
/// @param unit  of its coordinates, where a person has said it
/// Errors: UnknownFormat, FileUnreadable, MalformedFile, NoGeometry, with the file's name.
Result<PatternFile> readPatternFile(const std::filesystem::path& path,
                                    std::optional<FileUnit> unit = std::nullopt);

}  // namespace toile
