// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cotangents.h"

#include <Eigen/Geometry>

namespace toile {

Eigen::VectorXd cotangentWeights(const MeshArrays& mesh, const EdgeTable& table) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(table.edges.rows());
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto apex = mesh.V.row(mesh.F(f, (k + 2) % 3));
            const Eigen::Vector3d a = mesh.V.row(mesh.F(f, k)) - apex;
            const Eigen::Vector3d b = mesh.V.row(mesh.F(f, (k + 1) % 3)) - apex;
            weights[table.faceEdges(f, k)] += 0.5 * a.dot(b) / a.cross(b).norm();
        }
    }
    return weights;
}

}  // namespace toile
