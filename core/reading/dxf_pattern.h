// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// A DXF pattern as CLO, AccuMark, Optitex and others write it after AAMA-292 or ASTM D6673: a
/// block for each piece and size, what is meant told by the layer's number; or a drawing without
/// blocks whose layers say it by number or by name (CUT, SEW, GRAIN ...), in which each outer
/// closed line is a piece. Outlines that lie in several open lines are joined end to end, half
/// pieces beside a mirror line become whole, but for internal lines beside a text NM. Of a line and
/// its quality line (84 to 87) the one with more points counts. Keys of texts in any case.
/// @param stated  the file's unit where a person has said it; else its texts, its header and its
/// size tell
/// Errors: MalformedFile (no DXF file), NoGeometry (no closed line that could be a piece).
/// Cost: linear in the bytes; for drawings without blocks also in pieces times points. Pure.
Result<PatternFile> readDxfPattern(std::string_view bytes,
                                   std::optional<FileUnit> stated = std::nullopt);

}  // namespace toile
