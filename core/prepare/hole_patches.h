// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A surface with some holes closed: the original vertices and faces, then new ones.
struct PatchedSurface {
    MeshArrays mesh;
    std::vector<int> hole;  ///< per new face: index of the hole that it closes
};

/// Closes holes with patches of about the density of the surrounding mesh, which continue it
/// smoothly ([Lie03]). A hole stays open if every patch would put two triangles in one place, or if
/// it has more than 400 edges, because the cost is cubic in them.
/// @param mesh   mm, an oriented manifold (`isValidSurface`)
/// @param holes  rims of `mesh`
/// If cancelled between holes, returns the mesh with the holes closed so far. Pure.
PatchedSurface withPatches(const MeshArrays& mesh, std::span<const RimLoop> holes,
                           const Progress& progress);

}  // namespace toile
