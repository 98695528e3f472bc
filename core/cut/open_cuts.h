// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/cut_along.h"

namespace toile {

/// An edge that a path has cut although its two sides still have both ends in common: a vertex
/// between them is missing.
struct ShutEdge {
    int from, to;
    int face;  ///< the first of the two at it
};

/// A mesh parted along edges.
struct OpenedMesh {
    MeshArrays mesh;
    std::vector<int> copyOf;  ///< per vertex beyond those of the input: which one it copies
    std::vector<OpenedCut> cuts;
    std::vector<ShutEdge> stillShut;
};

/// Parts a mesh along paths of vertices, neighbours joined by an edge. Every vertex is divided into
/// as many copies as the cuts divide the triangles around it into groups; the first keeps its
/// number. Rim edges and edges cut by an earlier path are left out. Cost: linear.
OpenedMesh openAlong(MeshArrays mesh, const std::vector<std::vector<int>>& paths);

}  // namespace toile
