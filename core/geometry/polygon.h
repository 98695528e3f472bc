// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace toile::geometry {

/// Closed lines of the plane, as Points2: #n x 2, the first point not repeated. All pure and
/// linear.
using Polygon = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// 0 where it has fewer than two points.
double perimeterOf(const Polygon& closed);
/// Positive where it runs anti-clockwise.
double signedAreaOf(const Polygon& closed);
/// By crossings of a ray, an odd number of them.
bool isInside(const Polygon& closed, const Eigen::Vector2d& point);
/// Empty where it has no point.
Eigen::AlignedBox2d boxAround(const Polygon& points);
/// The corners of the convex hull, anti-clockwise; of fewer than three corners what there is.
/// Cost: n log n.
Polygon convexHull(const Polygon& points);
/// The same line anti-clockwise: as it is, or from its last point to its first.
Polygon antiClockwise(const Polygon& closed);

}  // namespace toile::geometry
