// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The two steps of preparing a scan that make new triangles. CGAL does them, which is included by
/// the file behind this alone. All meshes in mm, oriented manifolds (`isValidSurface`).

/// A surface of whose holes some are closed: vertices and faces as they were, then new ones.
struct PatchedSurface {
    MeshArrays mesh;
    std::vector<int> hole;  ///< per new face: index of the hole that it closes
};

/// Closes holes with patches of about the density of the mesh around, which go on from it without
/// an edge ([Lie03]). One stays open where no patch goes without two triangles in one place, or
/// where it has more than 400 edges, as the cost grows with their third power.
/// @param holes  rims of `mesh`
/// Cancelled between holes; what is closed by then is returned. Pure.
PatchedSurface withPatches(const MeshArrays& mesh, std::span<const RimLoop> holes,
                           const Progress& progress);

/// The surface anew of nearly equilateral triangles ([BK04]). Rims keep their corners, and their
/// lengths to 0.3 %; edges along them may be shorter than wanted where they are crooked.
/// @param edgeLength  mm, > 0
/// @return none where it was cancelled or CGAL gave up, where it would be millions of triangles, or
///         where more than 400 meet in a vertex; else mostly, but not for sure, a valid
///         surface: see `repair`
/// Cost: n log n, two seconds for 60 000 triangles. Pure.
std::optional<MeshArrays> remeshed(const MeshArrays& mesh, double edgeLength,
                                   const Progress& progress);

}  // namespace toile
