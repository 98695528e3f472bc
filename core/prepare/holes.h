// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The rims that are holes in the cloth and not openings: up to a perimeter, and with a surface
/// around them that lies like a patch, within 60 degrees on average. So neither the outline of a
/// small piece nor the end of a sleeve is a hole, however narrow: cloth stands across the opening.
/// @param largest  mm, perimeter
/// Cost: linear. Pure.
std::vector<RimLoop> findHoles(const MeshArrays& mesh, const EdgeTable& table, double largest);

/// How closely the cloth at a rim lies in the plane of a patch: the mean cosine between both along
/// the rim. 1: a hole in a plane; 0: the end of a tube; -1: the outline of a disk.
double flatness(const MeshArrays& mesh, const EdgeTable& table, const RimLoop& rim);

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
