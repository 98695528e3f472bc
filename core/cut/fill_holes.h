// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// A boundary loop of vertices, surface on its left, starting at its least index.
struct RimLoop {
    std::vector<int> vertices;
    double perimeter = 0;
};

/// All loops, in order of their least vertex. Precondition: manifold and oriented. Linear.
std::vector<RimLoop> rimLoops(const SurfaceLinks& links);

/// A mesh with caps: its own vertices and faces first, then one new vertex per hole and the fan of
/// triangles around it (a hole of three edges takes one triangle and no vertex).
struct FilledMesh {
    MeshArrays mesh;
    std::vector<int> sourceVertex;  ///< per vertex; -1 for the middle of a cap
    std::vector<int> sourceFace;    ///< per face; -1 for a cap
};

/// Closes holes for the solve; take the faces without source out again to have the holes back. Caps
/// need not lie flat: where a fan from the hole's middle would have a flat triangle, as in a
/// buttonhole that is shut, it is raised to a cone. Cost: linear. Pure.
FilledMesh fillHoles(const MeshArrays& mesh, const std::vector<RimLoop>& holes);

}  // namespace toile
