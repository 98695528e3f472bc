// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/document/line_facts.h"

namespace toile::app {

/// What a person decides of seam allowances, one edit each; the rest of the settings stays. All
/// pure.

/// The segments that an allowance is said of together: one, what is sewn to it, and their mirror
/// images.
/// @param bothSides  else the one alone, and its mirror image
/// @param symmetry   null: edits are not mirrored
std::vector<SegmentAt> alikeSegments(const Garment& garment, const LineFacts& facts,
                                     const SegmentAt& one, bool bothSides,
                                     const Symmetry* symmetry);

/// The width of the allowance beside a segment, as said of it or by its kind; where pieces have no
/// allowances, what it would be.
double allowanceOf(const Garment& garment, const Segment& segment, const LineSettings& lines);

/// With this width said of segments; none: by their kind. What is said of an allowance gives all
/// pieces theirs.
/// @param facts  of these lines
LineSettings withAllowance(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width);

/// With this said of how the allowances meet where a segment begins; none: by themselves.
/// @param image  its mirror image, where edits are mirrored: it ends in the corner that is meant
LineSettings withCorner(LineSettings lines, const LineFacts& facts, const SegmentAt& one,
                        const std::optional<SegmentAt>& image, std::optional<CornerRule> rule);

}  // namespace toile::app
