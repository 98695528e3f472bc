// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A mesh's cotangent weights, but those of the Delaunay triangulation in one part of it.
struct DelaunayAround {
    WeightedEdges
        graph;      ///< sorted, each pair of vertices once; outside of the part: the mesh's own
    int flips = 0;  ///< edges turned; 0: the graph is the mesh's own
};

/// Turns edges near the given faces, and only there, until the part of the surface that consists of
/// these faces and some rings about them is Delaunay (intrinsic_delaunay.h); its rim stays. The
/// result is the Laplacian of the same surface, differing from the mesh's own in a few rows.
/// @param own    cotangentWeights(mesh, table)
/// @param faces  indices into mesh.F
/// @param rings  faces at a corner of the given ones are the first ring, and so on
/// Precondition: no degenerate triangles. Errors: Cancelled. Cost: some linear passes, and
/// `intrinsicDelaunay` of the part. Deterministic. Re-entrant.
Result<DelaunayAround> delaunayAround(const MeshArrays& mesh, const EdgeTable& table,
                                      const Eigen::VectorXd& own, const std::vector<int>& faces,
                                      int rings, const Progress& progress);

}  // namespace toile
