// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace toile::geometry {

/// Corners of a polygon's triangles, as indices into the polygon's corners; anti-clockwise if the
/// polygon is.
using EarTriangles = std::vector<std::array<int, 3>>;

/// Divides a simple polygon into #corners - 2 triangles, cutting the best-shaped ear first, so that
/// corners on a straight line give no flat triangle if that can be avoided. Repeated positions and
/// edges that touch are tolerated.
/// @param polygon  at least 3 corners, anti-clockwise; any unit, extents of about 1
/// @return nothing if the polygon crosses itself
/// Cost: quadratic in the corners.
EarTriangles clipEars(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace toile::geometry
