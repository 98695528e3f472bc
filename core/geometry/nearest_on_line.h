// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/polygon.h"
#include "core/geometry/triangle_tree.h"

namespace toile::geometry {

/// Finds the points of a closed line in the plane that are closest to given points. Const use is
/// thread-safe. Cost: n log n in the line's points to build, log n per query.
class NearestOnLine {
public:
    /// @param closed  at least one point; its last is joined to its first
    explicit NearestOnLine(const Polygon& closed);

    /// The first along the line of equally close places.
    Eigen::RowVector2d operator()(const Eigen::RowVector2d& point) const;

private:
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> points_;
    TriangleTree<2, double> tree_;
};

}  // namespace toile::geometry
