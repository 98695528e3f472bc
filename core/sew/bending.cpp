// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/bending.h"

#include <cmath>

#include "core/mesh/edge_table.h"

namespace toile::sew {
namespace {

constexpr double kNewtonMillimetres = 1e3;  // N·m in N·mm

/// Cotangent of the angle at a corner of a triangle at rest.
double cotangentAt(const Points2& Q, int corner, int a, int b) {
    const Eigen::RowVector2d u = Q.row(a) - Q.row(corner), w = Q.row(b) - Q.row(corner);
    return u.dot(w) / std::abs(u[0] * w[1] - u[1] * w[0]);
}

}  // namespace

Bending::Bending(const Cloth& cloth, const PieceStiffness& stiffness) {
    const Triangles& F = cloth.patternF;
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(cloth.Q.rows()));
    const Eigen::VectorXd areas = restAreas(cloth);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        if (uses.size() != 2) {
            continue;
        }
        const double bending = stiffnessOf(stiffness, cloth.pieceOf[uses[0] / 3]).bending;
        if (bending <= 0) {
            continue;
        }
        const int a = table.edges(e, 0), b = table.edges(e, 1);
        Hinge hinge{{a, b, -1, -1}, {0, 0, 0, 0}, 0};
        double area = 0;
        for (int k = 0; k < 2; ++k) {
            const int apex = apexOf(F, uses[k]);
            const double atA = cotangentAt(cloth.Q, a, b, apex);
            const double atB = cotangentAt(cloth.Q, b, a, apex);
            hinge.vertex[2 + k] = apex;
            hinge.weight[0] += atB;
            hinge.weight[1] += atA;
            hinge.weight[2 + k] = -atA - atB;
            area += areas[uses[k] / 3];
        }
        hinge.stiffness = kNewtonMillimetres * bending / area;
        for (int& vertex : hinge.vertex) {
            vertex = cloth.clothVertex[vertex];
        }
        hinges_.push_back(hinge);
    }
}

Eigen::RowVector3d Bending::Hinge::bend(const Points3& X) const {
    Eigen::RowVector3d sum = weight[0] * X.row(vertex[0]);
    for (int i = 1; i < 4; ++i) {
        sum += weight[i] * X.row(vertex[i]);
    }
    return sum;
}

double Bending::energy(const Points3& X) const {
    double sum = 0;
    for (const Hinge& hinge : hinges_) {
        sum += hinge.stiffness * hinge.bend(X).squaredNorm() / 2;
    }
    return sum;
}

void Bending::addGradient(const Points3& X, Points3& g) const {
    for (const Hinge& hinge : hinges_) {
        const Eigen::RowVector3d force = hinge.stiffness * hinge.bend(X);
        for (int i = 0; i < 4; ++i) {
            g.row(hinge.vertex[i]) += hinge.weight[i] * force;
        }
    }
}

void Bending::addHessian(SpaceMatrix& H) const {
    for (const Hinge& hinge : hinges_) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j <= i; ++j) {
                const double value = hinge.stiffness * hinge.weight[i] * hinge.weight[j];
                const bool isSame = i != j && hinge.vertex[i] == hinge.vertex[j];  // sewn together
                H.add(hinge.vertex[i], hinge.vertex[j],
                      (isSame ? 2 : 1) * value * Eigen::Matrix3d::Identity());
            }
        }
    }
}

void Bending::addPairs(std::vector<std::pair<int, int>>& pairs) const {
    for (const Hinge& hinge : hinges_) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                if (hinge.vertex[i] != hinge.vertex[j]) {
                    pairs.emplace_back(hinge.vertex[i], hinge.vertex[j]);
                }
            }
        }
    }
}

}  // namespace toile::sew
