// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

struct Segment2 {
    Eigen::RowVector2d a, b;
};

/// Part of the plane: one side of a line within a larger part.
struct PlaneCell {
    const PlaneCell* whole = nullptr;  ///< null: this one is the plane
    Eigen::RowVector2d across{0, 0};   ///< the normal of the line
    double at = 0;                     ///< the line's position along it
    bool isBeyond = true;              ///< the line belongs to this side

    bool owns(const Eigen::RowVector2d& p) const {
        return whole == nullptr || ((p.dot(across) >= at) == isBeyond && whole->owns(p));
    }
};

/// Called with two segments (the smaller index first) that may meet in the cell; return false to
/// stop the search.
using PairVisitor = std::function<bool(int, int, const PlaneCell&)>;

/// Finds the pairs of segments that may meet within `margin`. The cells divide the plane: a pair
/// that meets at a place is reported for the cell that owns this place, and maybe for others too.
/// Sweeps across the direction in which most of a cell's segments run; if that leaves many pairs,
/// the cell is halved along or across this direction. Spirals, combs, stars of spikes that nearly
/// meet and fine details of large outlines cost about n log n, scribbles as much as their
/// crossings.
/// Deterministic, in no particular order. Returns false if the visitor stopped it.
bool visitSegmentPairs(const std::vector<Segment2>& segments, double margin,
                       const PairVisitor& visit);

}  // namespace toile::geometry
