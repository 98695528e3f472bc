// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/formats/drawing/drawing.h"
#include "core/garment/garment.h"
#include "core/geometry/line.h"

namespace toile {

/// A part of a line to be replaced by a few stations on it.
struct KeyStretch {
    const geometry::Line* line = nullptr;
    double from = 0, to = 0;  ///< mm along it: `from` in the first round, `to` not wrapped
    bool reversed = false;    ///< shares count from `to`

    double at(double share) const {
        return reversed ? to - share * (to - from) : from + share * (to - from);
    }
};

/// Tolerances of the polygon through key points against its line, mm.
inline constexpr double kKeyLost = 0.03;  ///< length lost over a whole stretch
inline constexpr double kKeyFar = 0.08;   ///< distance from the line

/// Shares of a stretch, or of two that are sewn together, at which both have points: enough to keep
/// each within kKeyLost and kKeyFar; 0 and 1 included, ascending. The parts with the largest loss
/// are halved at a vertex of the line, so that a straight line has its ends only and, at worst,
/// every vertex is a station; unnecessary stations are then removed.
/// @param sides  one or two, with a length above 0  @param fixed  required shares
/// Cost: vertices times the logarithm of stations. Pure.
std::vector<double> keyShares(std::span<const KeyStretch> sides, std::vector<double> fixed);

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
