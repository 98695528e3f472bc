// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/export/drawing.h"
#include "core/reading/pattern_match.h"

namespace toile {

/// A comparison of a pattern with one from a file, as JSON: each pair with what was compared, how
/// far the lines differ and by how much in length and area, and what has no partner.
/// Cost: linear. Pure.
std::string writePatternMatch(const Pattern& pattern, const PatternFile& file,
                              const PatternMatch& match);

/// Each pair as a picture, side by side at true scale: the line of the pattern on the layer of the
/// cutting lines, that of the file on it on the layer of the seam lines, and the name with the
/// figures. Ids `piece-<slug>-ours` and `-theirs`, with `-2` of a second line.
Drawing drawPatternMatch(const Pattern& pattern, const PatternFile& file,
                         const PatternMatch& match);

}  // namespace toile
