// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/edge_path.h"

#include "core/cut/surface_point.h"

namespace toile {

std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges) {
    std::vector<double> lengths(edges.rows());
    for (int e = 0; e < edges.rows(); ++e) {
        lengths[e] = (mesh.V.row(edges(e, 1)) - mesh.V.row(edges(e, 0))).norm();
    }
    return lengths;
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
