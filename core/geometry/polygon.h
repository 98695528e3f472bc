// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace toile::geometry {

/// Closed lines in the plane, as Points2: #n x 2, the first point not repeated. All functions are
/// pure and linear.
using Polygon = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// 0 for fewer than two points.
double perimeterOf(const Polygon& closed);
/// Positive if it runs anti-clockwise.
double signedAreaOf(const Polygon& closed);
/// Counts the crossings of a ray: inside if odd.
bool isInside(const Polygon& closed, const Eigen::Vector2d& point);
/// Empty if there are no points.
Eigen::AlignedBox2d boxAround(const Polygon& points);
/// The corners of the convex hull, anti-clockwise; fewer than three corners are returned as found.
/// Cost: n log n.
Polygon convexHull(const Polygon& points);
/// The same line anti-clockwise: unchanged, or reversed.
Polygon antiClockwise(const Polygon& closed);

}  // namespace toile::geometry
