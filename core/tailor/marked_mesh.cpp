// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/marked_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace toile::tailor {
namespace {

/// The vertex of each vertex of an opened mesh before its two sides were separated.
std::vector<int> closedAgain(const CutResult& cut, int sourceCount) {
    std::map<std::array<double, 4>, int> known;
    std::vector<int> closed;
    for (std::size_t v = 0; v < cut.place.size(); ++v) {
        int vertex = cut.sourceVertex[v];
        if (vertex < 0) {
            const SurfacePoint& at = cut.place[v];
            const int next = sourceCount + static_cast<int>(known.size());
            vertex = known
                         .try_emplace({static_cast<double>(at.face), at.barycentric[0],
                                       at.barycentric[1], at.barycentric[2]},
                                      next)
                         .first->second;
        }
        closed.push_back(vertex);
    }
    return closed;
}

}  // namespace

std::vector<char> MarkedMesh::marks() const {
    std::vector<char> marked(static_cast<std::size_t>(table.edges.rows()), 0);
    for (const std::vector<int>& way : ways) {
        for (std::size_t k = 1; k < way.size(); ++k) {
            marked[findEdge(table.edges, way[k - 1], way[k])] = 1;
        }
    }
    return marked;
}

std::set<int> MarkedMesh::vertices() const {
    std::set<int> all;
    for (const std::vector<int>& way : ways) {
        all.insert(way.begin(), way.end());
    }
    return all;
}

MarkedMesh markedMesh(const MeshArrays& mesh, const EdgeTable& table,
                      const std::vector<UserCut>& cuts, const Progress& progress) {
    MarkedMesh made{mesh, table, {}};
    if (cuts.empty()) {
        return made;
    }
    const SurfaceLinks links(mesh, table);
    const NearestSurface nearest(mesh);
    std::vector<PathPolyline> paths;
    for (const UserCut& cut : cuts) {
        if (auto path = traceUserCut(links, nearest, cut, progress)) {
            paths.push_back(std::move(*path));
        }
        if (progress.isCancelled()) {
            return made;
        }
    }
    const auto cut = cutAlong(mesh, paths, {.leavesOut = true}, progress);
    if (!cut) {
        return made;
    }
    const std::vector<int> closed = closedAgain(*cut, static_cast<int>(mesh.V.rows()));
    made.mesh.F = cut->mesh.F.unaryExpr([&closed](int v) { return closed[v]; });
    made.mesh.V.resize(*std::ranges::max_element(closed) + 1, 3);
    for (std::size_t v = 0; v < closed.size(); ++v) {
        made.mesh.V.row(closed[v]) = cut->mesh.V.row(static_cast<Eigen::Index>(v));
    }
    made.table = buildEdgeTable(made.mesh.F, static_cast<int>(made.mesh.V.rows()));
    for (const OpenedCut& opened : cut->cuts) {
        for (const CutRun& run : opened.runs) {
            std::vector<int>& way = made.ways.emplace_back();
            for (const int v : run.left) {
                way.push_back(closed[v]);
            }
        }
    }
    return made;
}

}  // namespace toile::tailor
