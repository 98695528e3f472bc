// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/mean_value.h"

#include <cmath>

#include "core/quality/measures.h"

namespace toile {

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

}  // namespace toile
