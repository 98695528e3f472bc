// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_links.h"

namespace toile {

/// Shortest ways along edges from a set of sources to everywhere (Dijkstra).
struct ShortestForest {
    std::vector<double> distance;  ///< per vertex; infinite where not reached
    std::vector<int> parentEdge;   ///< per vertex: edge towards its source, or -1
    std::vector<int> source;       ///< per vertex: index into the sources, or -1

    /// Vertices from a source to `vertex`, both included.
    std::vector<int> pathTo(int vertex, const Edges& edges) const;
};

/// Lengths of all edges.
std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges);

/// @param sources  each a set of vertices at distance zero
/// @param stopAt   ends early once this vertex is settled; -1: never
/// @param progress  polled; cancelled, the search ends where it is
/// Preconditions: weights are not negative, one per edge. Equal ways are decided by index.
/// Cost: O(#E log #E). Pure.
ShortestForest shortestForest(const Edges& edges, int vertexCount,
                              const std::vector<double>& weights,
                              const std::vector<std::vector<int>>& sources, int stopAt = -1,
                              const Progress& progress = Progress());

/// A way along edges.
struct EdgePath {
    std::vector<int> vertices;
    double length = 0;  ///< true length, whatever the weights
};

/// The way along edges of least total weight.
/// @param weights  one per edge, not negative; empty: the lengths
/// @errors  a cut error where the vertices are not connected; Cancelled
Result<EdgePath> edgePath(const MeshArrays& mesh, const EdgeTable& table, int from, int to,
                          const std::vector<double>& weights = {},
                          const Progress& progress = Progress());

/// The same curve as surface points. Precondition: neighbours share an edge.
PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices);

}  // namespace toile
