// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/directed_interior.h"

#include <cmath>

#include "core/linalg/sparse_lu.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Unknown of each vertex, numbered in vertex order; -1 on the boundary.
std::vector<int> unknowns(int vertexCount, const std::vector<int>& boundary) {
    std::vector<int> unknown(static_cast<std::size_t>(vertexCount), 0);
    for (const int v : boundary) {
        unknown[v] = -1;
    }
    int next = 0;
    for (int& u : unknown) {
        u = u < 0 ? -1 : next++;
    }
    return unknown;
}

}  // namespace

DirectedEdges meanValueWeights(const MeshArrays& mesh, const EdgeTable& table) {
    DirectedEdges graph{table.edges, Eigen::MatrixX2d::Zero(table.edges.rows(), 2)};
    const Eigen::MatrixX3d angles = cornerAngles3d(mesh);
    const Eigen::VectorXd lengths = edgeLengths3d(mesh.V, table.edges);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            // Both edges at corner k lie beside its angle.
            const double half = std::tan(0.5 * angles(f, k));
            for (const int e : {table.faceEdges(f, k), table.faceEdges(f, (k + 2) % 3)}) {
                const int side = table.edges(e, 0) == mesh.F(f, k) ? 0 : 1;
                graph.weights(e, side) += half / lengths[e];
            }
        }
    }
    return graph;
}

Result<Points2> solveDirected(const DirectedEdges& graph, int vertexCount,
                              const std::vector<int>& boundary, const Points2& outline,
                              const Progress& progress) {
    const std::vector<int> unknown = unknowns(vertexCount, boundary);
    const int size = vertexCount - static_cast<int>(boundary.size());
    Points2 Q = Points2::Zero(vertexCount, 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        Q.row(boundary[i]) = outline.row(static_cast<Eigen::Index>(i));
    }
    if (size == 0) {
        return Q;
    }
    std::vector<MatrixEntry> entries;
    entries.reserve(static_cast<std::size_t>(4 * graph.edges.rows()));
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, 2);
    for (int e = 0; e < graph.edges.rows(); ++e) {
        for (int side = 0; side < 2; ++side) {
            const int at = unknown[graph.edges(e, side)];
            const int other = graph.edges(e, 1 - side);
            const double weight = graph.weights(e, side);
            if (at < 0) {
                continue;
            }
            entries.push_back({at, at, weight});
            if (unknown[other] >= 0) {
                entries.push_back({at, unknown[other], -weight});
            } else {
                right.row(at) += weight * Q.row(other);
            }
        }
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    SparseLu lu;
    const auto factorised = lu.factorise(size, entries);
    if (!factorised) {
        return factorised.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const auto solved = lu.solve(right);
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "interior positions"};
    }
    for (int v = 0; v < vertexCount; ++v) {
        if (unknown[v] >= 0) {
            Q.row(v) = solved->row(unknown[v]);
        }
    }
    return Q;
}

}  // namespace toile
