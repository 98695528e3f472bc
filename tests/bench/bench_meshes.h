// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile::bench {

/// The two kinds of piece that speed is measured on, at any size: the same surface, sampled finer
/// or coarser. Both are disks in millimetres, with uneven triangles as a mesher leaves them (points
/// moved by up to a fifth of their distance, diagonals either way), the same at every call.
/// Cost: linear.

/// The front of a shirt over bust, waist and hip, in soft folds: nearly a plane, long outline.
/// @param triangles  wanted; the result has as many to within a few percent
MeshArrays panelMesh(int triangles);

/// A head with horns, ears and a plaited neck, open at the narrow neck: closed up and folded over
/// itself, so that neighbours in space need not be neighbours in the cloth.
MeshArrays headMesh(int triangles);

}  // namespace toile::bench
