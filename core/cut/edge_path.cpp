// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/edge_path.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "core/cut/surface_point.h"

namespace toile {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Between two looks at whether the search is still wanted: well below a millisecond.
constexpr int kVerticesPerPoll = 1024;

/// The edges at each vertex.
struct Stars {
    std::vector<int> start, edge;

    Stars(const Edges& edges, int vertexCount)
        : start(vertexCount + 1, 0), edge(static_cast<std::size_t>(edges.size())) {
        for (int i = 0; i < edges.size(); ++i) {
            ++start[edges.data()[i] + 1];
        }
        std::partial_sum(start.begin(), start.end(), start.begin());
        std::vector<int> next(start.begin(), start.end() - 1);
        for (int i = 0; i < edges.size(); ++i) {
            edge[next[edges.data()[i]]++] = i / 2;
        }
    }
};

}  // namespace

std::vector<int> ShortestForest::pathTo(int vertex, const Edges& edges) const {
    std::vector<int> path{vertex};
    while (parentEdge[vertex] >= 0) {
        const auto ends = edges.row(parentEdge[vertex]);
        vertex = ends[0] == vertex ? ends[1] : ends[0];
        path.push_back(vertex);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges) {
    std::vector<double> lengths(edges.rows());
    for (int e = 0; e < edges.rows(); ++e) {
        lengths[e] = (mesh.V.row(edges(e, 1)) - mesh.V.row(edges(e, 0))).norm();
    }
    return lengths;
}

ShortestForest shortestForest(const Edges& edges, int vertexCount,
                              const std::vector<double>& weights,
                              const std::vector<std::vector<int>>& sources, int stopAt,
                              const Progress& progress) {
    const Stars stars(edges, vertexCount);
    ShortestForest forest{std::vector<double>(vertexCount, kInfinity),
                          std::vector<int>(vertexCount, -1), std::vector<int>(vertexCount, -1)};
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
        for (int i = stars.start[v]; i < stars.start[v + 1]; ++i) {
            const int e = stars.edge[i];
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

Result<EdgePath> edgePath(const MeshArrays& mesh, const EdgeTable& table, int from, int to,
                          const std::vector<double>& weights, const Progress& progress) {
    const ShortestForest forest = shortestForest(
        table.edges, static_cast<int>(mesh.V.rows()),
        weights.empty() ? edgeLengths(mesh, table.edges) : weights, {{from}}, to, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    if (forest.source[to] < 0) {
        return cutError("", worded("the points lie on parts that are not connected"));
    }
    EdgePath path{forest.pathTo(to, table.edges), 0};
    for (std::size_t i = 1; i < path.vertices.size(); ++i) {
        path.length += (mesh.V.row(path.vertices[i]) - mesh.V.row(path.vertices[i - 1])).norm();
    }
    return path;
}

PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices) {
    PathPolyline path;
    for (const int v : vertices) {
        path.points.push_back(links.atVertex(v));
    }
    path.length = measuredLength(links.mesh(), path);
    return path;
}

}  // namespace toile
