// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/authalic.h"

#include <cmath>

#include "core/flatten/interior/interior.h"
#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"

namespace toile {

DirectedEdges authalicWeights(const MeshArrays& mesh, const EdgeTable& table) {
    DirectedEdges graph{table.edges, Eigen::MatrixX2d::Zero(table.edges.rows(), 2)};
    const Eigen::MatrixX3d angles = cornerAngles3d(mesh);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const double cotangent = 1 / std::tan(angles(f, k));
            for (const int e : {table.faceEdges(f, k), table.faceEdges(f, (k + 2) % 3)}) {
                // The angle at v_j counts in the equation of the edge's other end, v_i.
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
        return fillInterior(mesh, table, boundary, outline, progress);
    }
    DirectedEdges graph = authalicWeights(mesh, table);
    graph.weights *= mu;
    graph.weights.colwise() += 2 * (1 - mu) * cotangentWeights(mesh, table);
    return solveDirected(graph, static_cast<int>(mesh.V.rows()), boundary, outline, progress);
}

}  // namespace toile
