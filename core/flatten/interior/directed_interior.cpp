// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/directed_interior.h"

#include <cmath>

#include "core/flatten/interior/interior.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"

namespace toile {
DirectedEdges meanValueWeights(const MeshArrays& mesh, const EdgeTable& table) {
    DirectedEdges graph{table.edges, Eigen::MatrixX2d::Zero(table.edges.rows(), 2)};
    const Eigen::MatrixX3d angles = cornerAngles3d(mesh);
    const Eigen::VectorXd lengths = edgeLengths3d(mesh.V, table.edges);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            // Both edges at corner k are adjacent to its angle.
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
    const std::vector<int> unknown = unknownsBut(boundary, vertexCount);
    const int size = vertexCount - static_cast<int>(boundary.size());
    Points2 Q = Points2::Zero(vertexCount, 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        Q.row(boundary[i]) = outline.row(static_cast<Eigen::Index>(i));
    }
    if (size == 0) {
        return Q;
    }
    std::vector<Eigen::Triplet<double>> entries;
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
            entries.emplace_back(at, at, weight);
            if (unknown[other] >= 0) {
                entries.emplace_back(at, unknown[other], -weight);
            } else {
                right.row(at) += weight * Q.row(other);
            }
        }
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const auto solved = linalg::solveUnsymmetric(entries, right);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
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

DirectedEdges authalicWeights(const MeshArrays& mesh, const EdgeTable& table) {
    DirectedEdges graph{table.edges, Eigen::MatrixX2d::Zero(table.edges.rows(), 2)};
    const Eigen::MatrixX3d angles = cornerAngles3d(mesh);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const double cotangent = 1 / std::tan(angles(f, k));
            for (const int e : {table.faceEdges(f, k), table.faceEdges(f, (k + 2) % 3)}) {
                // The angle at v_j enters the equation of the edge's other end, v_i.
                const int side = table.edges(e, 0) == mesh.F(f, k) ? 1 : 0;
                graph.weights(e, side) += cotangent;
            }
        }
    }
    const Eigen::ArrayXd squares = edgeLengths3d(mesh.V, table.edges).array().square();
    const Eigen::ArrayXd scale = squares.mean() / squares;
    graph.weights.array().colwise() *= scale;
    return graph;
}

Result<Points2> fillInteriorMixed(const MeshArrays& mesh, const EdgeTable& table,
                                  const std::vector<int>& boundary, const Points2& outline,
                                  double mu, const Progress& progress) {
    if (mu == 0) {
        return fillInterior({table.edges, cotangentWeights(mesh, table)}, mesh.V, boundary, outline,
                            progress);
    }
    DirectedEdges graph = authalicWeights(mesh, table);
    graph.weights *= mu;
    graph.weights.colwise() += 2 * (1 - mu) * cotangentWeights(mesh, table);
    return solveDirected(graph, static_cast<int>(mesh.V.rows()), boundary, outline, progress);
}

}  // namespace toile
