// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

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

}  // namespace toile
