// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace toile {

struct Segment2 {
    Eigen::RowVector2d a, b;
};

/// Part of the plane; the lower sides belong to it, the upper do not.
struct PlaneCell {
    Eigen::RowVector2d low, high;

    bool owns(const Eigen::RowVector2d& p) const {
        return (p.array() >= low.array()).all() && (p.array() < high.array()).all();
    }
};

/// Told of two segments (the smaller index first) that may meet in the cell; false: look no
/// further.
using PairVisitor = std::function<bool(int, int, const PlaneCell&)>;

/// Finds the pairs of segments that may meet within `margin`. The cells divide the plane: a pair
/// that meets in a place is named for the cell that owns this place, and maybe for others too. By
/// a sweep across the direction in which most of a cell's segments run; a cell in which that leaves
/// many pairs is quartered. So spirals, combs and fine details of large outlines cost about
/// n log n, a star of n spikes that nearly meet about n^1.5, and scribbles what their crossings do.
/// Deterministic, in an order of its own. Returns false where the visitor ended it.
bool visitSegmentPairs(const std::vector<Segment2>& segments, double margin,
                       const PairVisitor& visit);

}  // namespace toile
