// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <set>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// Shapes that are no disks, beyond those of shapes.h.

using Cell = std::array<int, 3>;

/// The surface of a body made of cubes of one size, by their places.
MeshArrays voxelSurface(const std::set<Cell>& cells, double side);
/// A box without its bottom, on z = 0 with a corner at the origin: n squares along every edge.
MeshArrays openBox(int n, double side);
/// The same with its bottom.
MeshArrays closedBox(int n, double side);
/// piercedTorus with its last triangle put back.
MeshArrays closedTorus(int around, int across);
/// A profile of radius and height turned about the y axis: a ring between its two ends.
MeshArrays revolution(const std::vector<Eigen::Vector2d>& profile, int around);
/// A sphere of radius 50 with poles on the z axis.
MeshArrays sphere(int rings);
/// The mesh without some faces, and without the vertices that no face uses any more.
MeshArrays without(const MeshArrays& mesh, const std::function<bool(int face)>& isOut);

}  // namespace toile::test
