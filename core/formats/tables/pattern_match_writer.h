// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/formats/drawing/drawing.h"
#include "core/formats/tables/pattern_match.h"

namespace toile {

/// A comparison of a pattern with one from a file, as JSON: each pair with the compared lines,
/// their distance and the differences of length and area, and the pieces without a partner.
/// Cost: linear. Pure.
std::string writePatternMatch(const Pattern& pattern, const PatternFile& file,
                              const PatternMatch& match);

/// Each pair as a picture, side by side at true scale: the pattern's line on the layer of the
/// cutting lines, the file's line over it on the layer of the seam lines, and the name with the
/// figures. Ids `piece-<slug>-ours` and `-theirs`, with `-2` for a second line.
Drawing drawPatternMatch(const Pattern& pattern, const PatternFile& file,
                         const PatternMatch& match);

}  // namespace toile
