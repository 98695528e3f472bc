// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/geometry/line.h"

namespace toile {

/// A part of a line that a few stations on it are to stand for.
struct KeyStretch {
    const geometry::Line* line = nullptr;
    double from = 0, to = 0;  ///< mm along it: `from` within the first turn, `to` counted on
    bool reversed = false;    ///< shares count from `to`

    double at(double share) const {
        return reversed ? to - share * (to - from) : from + share * (to - from);
    }
};

/// How far the polygon through key points may be from its line, mm.
inline constexpr double kKeyLost = 0.03;  ///< shorter, a whole stretch
inline constexpr double kKeyFar = 0.08;   ///< beside it

/// Shares of a stretch, or of two that are sewn together, at which the points of both lie: so many
/// that each is kept to kKeyLost and kKeyFar, 0 and 1 among them, ascending. Parts that lose most
/// are halved at a vertex of the line, so that a straight line has its ends alone and, at worst,
/// every vertex is a station; then those that are not needed go again.
/// @param sides  one or two, of some length  @param fixed  shares that are to be there
/// Cost: vertices times the logarithm of stations. Pure.
std::vector<double> keyShares(std::span<const KeyStretch> sides, std::vector<double> fixed);

}  // namespace toile
