// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

struct Segment2 {
    Eigen::RowVector2d a, b;
};

/// Part of the plane: what lies on one side of a line, in a larger part.
struct PlaneCell {
    const PlaneCell* whole = nullptr;  ///< null: this one is the plane
    Eigen::RowVector2d across{0, 0};   ///< of the line
    double at = 0;                     ///< the line's place along it
    bool isBeyond = true;              ///< the line belongs to this side

    bool owns(const Eigen::RowVector2d& p) const {
        return whole == nullptr || ((p.dot(across) >= at) == isBeyond && whole->owns(p));
    }
};

/// Told of two segments (the smaller index first) that may meet in the cell; false: look no
/// further.
using PairVisitor = std::function<bool(int, int, const PlaneCell&)>;

/// Finds the pairs of segments that may meet within `margin`. The cells divide the plane: a pair
/// that meets in a place is named for the cell that owns this place, and maybe for others too. By
/// a sweep across the direction in which most of a cell's segments run; a cell in which that leaves
/// many pairs is halved, along this direction or across it. So spirals, combs, stars of spikes that
/// nearly meet and fine details of large outlines cost about n log n, and scribbles what their
/// crossings do.
/// Deterministic, in an order of its own. Returns false where the visitor ended it.
bool visitSegmentPairs(const std::vector<Segment2>& segments, double margin,
                       const PairVisitor& visit);

}  // namespace toile::geometry
