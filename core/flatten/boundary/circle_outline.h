// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The convex polygon with the given edge lengths inscribed in a circle, anti-clockwise, edge i
/// from vertex i to i+1. It exists and is unique where no edge is as long as all others together;
/// with one long edge the circle's centre lies outside. No three vertices are in line.
/// @param lengths  n >= 3, positive  @return n x 2, unit of the lengths
/// Errors: NoClosedOutline. Cost: one scalar root, O(n) per step. Pure.
Result<Points2> circleOutline(const Eigen::VectorXd& lengths);

}  // namespace toile
