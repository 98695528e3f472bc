// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/export/drawing.h"
#include "core/garment/garment.h"

namespace toile {

/// Turn and curve points of drawn lines, for formats whose readers fit their own curves through a
/// few points.

struct KeyPoint {
    double at = 0;        ///< mm along the line, in the first round
    bool isTurn = false;  ///< the line turns here, or another segment begins; else a curve point
};

using KeyPoints = std::vector<KeyPoint>;

/// Key points of each line of the layers Cut, Sew and Internal; no others. Every key point is on
/// its line. Turn points are the ends of open lines, of segments and of seams, and corners. The
/// polygon through the key points is as long as the line within kKeyLost between consecutive turn
/// points of a line without seams, and over each whole side of a seam; every vertex of the line is
/// within kKeyFar of it (key_stations.h). A straight line has its ends only. Both sides of a seam
/// have key points at the same shares of their lengths, if both are drawn whole, or up to the same
/// fold. A closed line begins at a turn point if it has one, and goes once round.
/// @param drawing  of the pattern  @param garment  its seams define the directions of both sides;
/// without seams: opposite
/// @return one per path  Cost: that of `keyShares` for each line. Pure.
std::vector<KeyPoints> keyPoints(const Drawing& drawing, const Pattern& pattern,
                                 const Garment& garment);

/// Minimum length of a straight run in a bent line, mm: its ends are key points if it also has
/// three edges or more.
inline constexpr double kStraightRun = 10;

}  // namespace toile
