// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/piece_edits.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/cut/cut_along.h"
#include "core/cut/surface_paths.h"
#include "core/mesh/repair.h"

namespace toile::test {
namespace {

/// Lengths of the ways from a set of vertices to all others.
geometry::ShortestForest forestFrom(const Piece& piece, const std::vector<int>& sources) {
    return geometry::shortestForest(piece.table.edges, static_cast<int>(piece.mesh.V.rows()),
                                    edgeLengths(piece.mesh, piece.table.edges), {sources});
}

std::vector<int> innerWay(const Piece& piece, int start, int edges) {
    const std::vector<double> depth = forestFrom(piece, piece.boundary).distance;
    const geometry::ShortestForest ways = forestFrom(piece, {piece.boundary[start]});
    std::vector<int> best;
    double deepest = 0;
    for (int v = 0; v < piece.mesh.V.rows(); ++v) {
        if (depth[v] > 0 && (best.empty() || depth[v] > deepest)) {
            std::vector<int> way = ways.pathTo(v, piece.table.edges);
            if (static_cast<int>(way.size()) <= edges + 1) {
                best = std::move(way);
                deepest = depth[v];
            }
        }
    }
    return best;
}

}  // namespace

std::shared_ptr<const Piece> originalPiece(MeshArrays mesh) {
    auto piece = std::make_shared<Piece>(makePiece("piece", std::move(mesh)));
    piece->sourceVertex.resize(static_cast<std::size_t>(piece->mesh.V.rows()));
    std::iota(piece->sourceVertex.begin(), piece->sourceVertex.end(), 0);
    piece->sourceFace.resize(static_cast<std::size_t>(piece->mesh.F.rows()));
    std::iota(piece->sourceFace.begin(), piece->sourceFace.end(), 0);
    return piece;
}

PathPolyline dartAlongEdges(const Piece& piece, int start, int edges) {
    return polylineOf(SurfaceLinks(piece.mesh, piece.table), innerWay(piece, start, edges));
}

PathPolyline straightDart(const Piece& piece, int start, int edges) {
    const std::vector<int> way = innerWay(piece, start, edges);
    const SurfaceLinks links(piece.mesh, piece.table);
    return *geodesicPath(links, links.atVertex(way.front()), links.atVertex(way.back()));
}

std::shared_ptr<const Piece> opened(const Piece& piece, const std::vector<PathPolyline>& paths) {
    auto cut = *cutAlong(piece.mesh, paths);
    MeshPart part;
    for (const int v : cut.sourceVertex) {
        part.sourceVertex.push_back(v < 0 ? -1 : piece.sourceVertex[v]);
    }
    for (const int f : cut.sourceFace) {
        part.sourceFace.push_back(piece.sourceFace[f]);
    }
    part.mesh = std::move(cut.mesh);
    auto parts = connectedParts(std::move(part));
    auto& largest =
        std::ranges::max_element(parts, {}, [](const ConnectedPart& one) -> Eigen::Index {
            return one.part.mesh.F.rows();
        })->part;
    auto made = std::make_shared<Piece>(makePiece(piece.name, std::move(largest.mesh)));
    made->sourceVertex = std::move(largest.sourceVertex);
    made->sourceFace = std::move(largest.sourceFace);
    return made;
}

std::shared_ptr<const Piece> dragged(const Piece& piece, int vertex,
                                     const Eigen::RowVector3d& offset) {
    MeshArrays mesh = piece.mesh;
    mesh.V.row(vertex) += offset;
    auto made = std::make_shared<Piece>(makePiece(piece.name, std::move(mesh)));
    made->sourceVertex = piece.sourceVertex;
    made->sourceFace = piece.sourceFace;
    return made;
}

int deepestVertex(const Piece& piece) {
    const std::vector<double> depth = forestFrom(piece, piece.boundary).distance;
    return static_cast<int>(std::ranges::max_element(depth) - depth.begin());
}

}  // namespace toile::test
