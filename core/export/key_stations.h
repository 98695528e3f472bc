// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A polyline of a drawing by its arc lengths, open or closed. Places on a closed one count on
/// over any number of turns. Immutable.
class StationLine {
public:
    /// @param points  #n x 2, mm, n >= 1; of a closed line the first is not repeated
    StationLine(const Points2& points, bool closed);

    bool isClosed() const { return closed_; }
    double length() const { return arc_.back(); }
    std::size_t vertexCount() const;
    /// Arc length of a vertex; of closed lines k counts on over turns.
    double arcOf(std::size_t k) const;
    Eigen::Vector2d vertex(std::size_t k) const;
    /// The first vertex that lies beyond a place of the first turn.
    std::size_t firstBeyond(double at) const;
    /// The place within the first turn.
    double wrapped(double at) const;
    Eigen::Vector2d pointAt(double at) const;

private:
    Points2 points_;           ///< of a closed line the first once more
    std::vector<double> arc_;  ///< of these
    bool closed_;
};

/// A part of a line that a few stations on it are to stand for.
struct KeyStretch {
    const StationLine* line = nullptr;
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
