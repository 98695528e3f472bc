// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"

namespace toile::geometry {

/// The edges of a graph, #E x 2: the two vertices of each.
using VertexPairs = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// Shortest paths along edges from a set of sources to all vertices (Dijkstra).
struct ShortestForest {
    std::vector<double> distance;  ///< per vertex; infinite where not reached
    std::vector<int> parentEdge;   ///< per vertex: edge towards its source, or -1
    std::vector<int> source;       ///< per vertex: index into the sources, or -1

    /// Vertices from a source to `vertex`, both included.
    std::vector<int> pathTo(int vertex, const VertexPairs& edges) const;
};

/// @param sources  each a set of vertices at distance zero
/// @param stopAt   stops once this vertex is settled; -1: never
/// @param progress  polled; if cancelled, the search stops early
/// Preconditions: weights are not negative, one per edge. Ties are decided by index.
/// Cost: O(#E log #E). Pure.
ShortestForest shortestForest(const VertexPairs& edges, int vertexCount,
                              const std::vector<double>& weights,
                              const std::vector<std::vector<int>>& sources, int stopAt = -1,
                              const Progress& progress = Progress());

}  // namespace toile::geometry
