// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/polygon.h"
#include "core/geometry/triangle_tree.h"

namespace toile::geometry {

/// Finds the points of a closed line of the plane that are nearest to others. Const use is
/// thread-safe. Cost: n log n in the line's points to make, log n a question.
class NearestOnLine {
public:
    /// @param closed  at least one point; its last is joined to its first
    explicit NearestOnLine(const Polygon& closed);

    /// Of places equally near the first along the line.
    Eigen::RowVector2d operator()(const Eigen::RowVector2d& point) const;

private:
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> points_;
    TriangleTree<2, double> tree_;
};

}  // namespace toile::geometry
