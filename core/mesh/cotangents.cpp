// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cotangents.h"

namespace toile {

Eigen::VectorXd cotangentWeights(const MeshArrays& mesh, const EdgeTable& table) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(table.edges.rows());
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const CornerProducts corners = cornerProducts(mesh, f);
        const double half = 0.5 / corners.doubledArea;
        for (int k = 0; k < 3; ++k) {
            weights[table.faceEdges(f, k)] += half * corners.at[(k + 2) % 3];
        }
    }
    return weights;
}

}  // namespace toile
