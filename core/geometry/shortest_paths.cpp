// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shortest_paths.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "core/geometry/buckets.h"

namespace toile::geometry {
namespace {

/// Vertices between two checks for cancellation: well below a millisecond.
constexpr int kVerticesPerPoll = 1024;

}  // namespace

std::vector<int> ShortestForest::pathTo(int vertex, const VertexPairs& edges) const {
    std::vector<int> path{vertex};
    while (parentEdge[vertex] >= 0) {
        const auto ends = edges.row(parentEdge[vertex]);
        vertex = ends[0] == vertex ? ends[1] : ends[0];
        path.push_back(vertex);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

ShortestForest shortestForest(const VertexPairs& edges, int vertexCount,
                              const std::vector<double>& weights,
                              const std::vector<std::vector<int>>& sources, int stopAt,
                              const Progress& progress) {
    const Buckets<> edgesAt(vertexCount, [&edges](auto add) {
        for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
            add(edges.data()[i], i / 2);
        }
    });
    constexpr double kFar = std::numeric_limits<double>::infinity();
    ShortestForest forest{std::vector<double>(vertexCount, kFar), std::vector<int>(vertexCount, -1),
                          std::vector<int>(vertexCount, -1)};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        for (const int v : sources[s]) {
            forest.distance[v] = 0;
            forest.source[v] = static_cast<int>(s);
            open.emplace(0.0, v);
        }
    }
    for (int count = 0; !open.empty(); ++count) {
        if (count % kVerticesPerPoll == 0 && progress.isCancelled()) {
            break;
        }
        const auto [distance, v] = open.top();
        open.pop();
        if (v == stopAt) {
            break;
        }
        if (distance > forest.distance[v]) {
            continue;
        }
        for (const int e : edgesAt[v]) {
            const int w = edges(e, 0) == v ? edges(e, 1) : edges(e, 0);
            const double reached = distance + weights[e];
            if (reached < forest.distance[w]) {
                forest.distance[w] = reached;
                forest.parentEdge[w] = e;
                forest.source[w] = forest.source[v];
                open.emplace(reached, w);
            }
        }
    }
    return forest;
}

}  // namespace toile::geometry
