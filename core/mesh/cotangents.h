// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The values that give the angles of a triangle: at corner k the tangent is doubledArea / at[k].
struct CornerProducts {
    double at[3];  ///< inner product of the two sides at each corner; they sum to half the sum
                   ///< of the squared sides
    double doubledArea;  ///< length of their cross product, the same at each
};

inline CornerProducts cornerProducts(const MeshArrays& mesh, int face) {
    // If two sides are more than a hundred times as long as the third, their cross product loses
    // digits that the product of one of them with the third keeps.
    constexpr double kNeedle = 1e-4;
    const int i = mesh.F(face, 0), j = mesh.F(face, 1), k = mesh.F(face, 2);
    const Eigen::Vector3d ij = mesh.V.row(j) - mesh.V.row(i);
    const Eigen::Vector3d ik = mesh.V.row(k) - mesh.V.row(i);
    const Eigen::Vector3d jk = mesh.V.row(k) - mesh.V.row(j);
    const bool isNeedle = jk.squaredNorm() < kNeedle * ij.squaredNorm();
    return {{ij.dot(ik), -ij.dot(jk), ik.dot(jk)}, ij.cross(isNeedle ? jk : ik).norm()};
}

/// Conformal weight of each edge: half the sum of the cotangents of the angles opposite to it
/// ([DMA02] eq. 5 with the half of the Dirichlet energy). Scale-free. Negative if those angles sum
/// to more than pi. Precondition: no degenerate triangles.
inline Eigen::VectorXd cotangentWeights(const MeshArrays& mesh, const EdgeTable& table) {
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
