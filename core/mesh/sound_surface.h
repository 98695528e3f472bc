// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// True where a mesh is plainly an oriented manifold with boundary: every vertex is used and
/// finite; every triangle has three sides and a height, well above rounding; every edge has one
/// face, or two different ones that run along it in opposite directions; the faces around each
/// vertex hang together. Then `repair` has nothing to do, and `checkDisk` only loops to count. Most
/// meshes are, and this is many times faster than either.
/// False where there is doubt: that says nothing about which of it fails.
/// @param table  the edges of `mesh`
/// Cost: linear, a few passes. Pure.
bool isSoundSurface(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
