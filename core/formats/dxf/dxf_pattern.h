// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/formats/pattern_file.h"

namespace toile {

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

}  // namespace toile
