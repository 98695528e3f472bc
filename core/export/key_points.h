// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/export/drawing.h"
#include "core/garment/garment.h"

namespace toile {

/// Turn and curve points of drawn lines, for formats whose readers lay curves of their own through
/// a few points.

struct KeyPoint {
    double at = 0;        ///< mm along the line, within the first turn
    bool isTurn = false;  ///< the line turns here, or another segment begins; else a curve point
};

using KeyPoints = std::vector<KeyPoint>;

/// Of each line of the layers Cut, Sew and Internal; none of the others. Every key point lies on
/// its line. Turn points are the ends of open lines, of segments and of seams, and corners. The
/// polygon through the key points is as long as the line to kKeyLost between any two turn points
/// that follow each other on a line without seams, and over each whole side of a seam; no vertex
/// of the line is farther from it than kKeyFar (key_stations.h). Of a straight line there are the
/// ends alone. Both sides of a seam have key points at the same shares of their lengths, where
/// both are drawn whole, or as far as the same fold. A closed line begins at a turn point where it
/// has one, and goes once round.
/// @param drawing  of the pattern  @param garment  whose seams say which way both sides run; one
///                 without seams: against each other
/// @return one per path  Cost: that of `keyShares` for each line. Pure.
std::vector<KeyPoints> keyPoints(const Drawing& drawing, const Pattern& pattern,
                                 const Garment& garment);

/// Ends of a straight run along a line that bends elsewhere are key points where the run has three
/// edges or more and is so long, mm.
inline constexpr double kStraightRun = 10;

}  // namespace toile
