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

/// Kind of a pattern file by its extension, in any case; a .json file is one of GarmentCode if its
/// name or its content says so. None for other files.
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

/// Reads a DXF pattern as written by CLO, AccuMark, Optitex and others after AAMA-292 or ASTM
/// D6673: one block per piece and size, in which layer numbers give the meaning. Also reads
/// drawings without blocks, whose layers have such numbers or names (CUT, SEW, GRAIN ...): each
/// outer closed line is a piece. Joins outlines of several open lines end to end. Unfolds half
/// pieces at their mirror line, except internal lines with a text NM. Of a line and its quality
/// line (84 to 87), uses the one with more points. Keys of texts are case-insensitive.
/// @param stated  the file's unit if the user has set it; else derived from texts, header and size
/// Errors: MalformedFile (no DXF file), NoGeometry (no closed line that could be a piece).
/// Cost: linear in the bytes; for drawings without blocks also in pieces times points. Pure.
Result<PatternFile> readDxfPattern(std::string_view bytes,
                                   std::optional<FileUnit> stated = std::nullopt);

/// Reads an SVG drawing as a pattern. Toile's own files name piece and layer of each line. In
/// others each outer closed line is a piece; closed lines inside it are holes, or its seam line if
/// they fill most of it.
/// @param stated  unit of the coordinates, set by the user if the file is not at true scale
/// Errors: MalformedFile, NoGeometry (no closed line). Cost: linear; for other programs' files also
/// pieces times points. Pure.
Result<PatternFile> readSvgPattern(std::string_view bytes,
                                   std::optional<FileUnit> stated = std::nullopt);

}  // namespace toile
