// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/membrane.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "core/sew/side_by_side.h"

namespace toile::sew {
namespace {

constexpr double kMillimetres = 1e-3;  // N/m in N/mm

using Deformation = Eigen::Matrix<double, 3, 2>;

Eigen::Matrix2d greenStrain(const Deformation& F) {
    return (F.transpose() * F - Eigen::Matrix2d::Identity()) / 2;
}

/// The stress without its compressive part.
Eigen::Matrix2d tensionOf(const Eigen::Matrix2d& stress) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(stress);
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace

Membrane::Membrane(const Cloth& cloth, const PieceStiffness& stiffness)
    : cloth_(cloth),
      rest_(restShapes(cloth)),
      corners_(static_cast<int>(cloth.X.rows()),
               [&cloth](auto add) {
                   for (int corner = 0; corner < static_cast<int>(cloth.F.size()); ++corner) {
                       add(cloth.F(corner / 3, corner % 3), corner);
                   }
               }),
      moduli_(pieceCount(cloth)) {
    for (std::size_t piece = 0; piece < moduli_.size(); ++piece) {
        const ClothStiffness& of = stiffnessOf(stiffness, static_cast<int>(piece));
        moduli_[piece] << of.weft, of.coupling, 0,  //
            of.coupling, of.warp, 0,                //
            0, 0, of.shear;
        moduli_[piece] *= kMillimetres;
    }
}

Eigen::Matrix2d Membrane::stress(Eigen::Index f, const Eigen::Matrix2d& green) const {
    const Eigen::Vector3d s =
        moduliOf(f) * Eigen::Vector3d(green(0, 0), green(1, 1), 2 * green(0, 1));
    Eigen::Matrix2d stress;
    stress << s[0], s[2], s[2], s[1];
    return stress;
}

double Membrane::energy(const Points3& X) const {
    double sum = 0;
    for (Eigen::Index f = 0; f < cloth_.F.rows(); ++f) {
        const Eigen::Matrix2d green = greenStrain(deformation(rest_[f], cloth_.F, f, X));
        sum += rest_[f].area * stress(f, green).cwiseProduct(green).sum() / 2;
    }
    return sum;
}

template <class Add>
void Membrane::forEachForce(const Points3& X, Add add) const {
    for (Eigen::Index f = 0; f < cloth_.F.rows(); ++f) {
        const Deformation F = deformation(rest_[f], cloth_.F, f, X);
        const Deformation pulled = rest_[f].area * F * stress(f, greenStrain(F));
        for (int k = 0; k < 3; ++k) {
            add(cloth_.F(f, k), Eigen::Vector3d(pulled * rest_[f].b[k]));
        }
    }
}

void Membrane::addGradient(const Points3& X, Points3& g) const {
    forEachForce(X, [&](int v, const Eigen::Vector3d& force) { g.row(v) += force.transpose(); });
}

void Membrane::addForceSizes(const Points3& X, Eigen::VectorXd& sizes) const {
    forEachForce(X, [&](int v, const Eigen::Vector3d& force) { sizes[v] += force.norm(); });
}

void Membrane::addHessian(const Points3& X, SpaceMatrix& H, int threads) const {
    struct Pull {
        Deformation F;
        Eigen::Matrix2d tension;
    };
    std::vector<Pull> pulls(rest_.size());
    sideBySide(threads, pulls.size(), [&](std::size_t f) {
        const auto row = static_cast<Eigen::Index>(f);
        pulls[f].F = deformation(rest_[f], cloth_.F, row, X);
        pulls[f].tension = tensionOf(stress(row, greenStrain(pulls[f].F)));
    });
    // Derivatives of E11, E22 and 2 E12 with respect to a corner.
    const auto byStrain = [](const Deformation& F, const Eigen::Vector2d& b) {
        Eigen::Matrix3d by;
        by << F.col(0) * b[0], F.col(1) * b[1], F.col(0) * b[1] + F.col(1) * b[0];
        return by;
    };
    // The thread of its smaller vertex adds each pair of corners, so that no writes conflict.
    sideBySide(threads, static_cast<std::size_t>(X.rows()), [&](std::size_t vertex) {
        const int v = static_cast<int>(vertex);
        for (const int corner : corners_[v]) {
            const int f = corner / 3;
            const RestShape& rest = rest_[f];
            for (int k = 0; k < 3; ++k) {
                if (cloth_.F(f, k) < v) {
                    continue;
                }
                const int other = corner % 3, i = std::max(k, other), j = std::min(k, other);
                const double along = rest.area * rest.b[i].dot(pulls[f].tension * rest.b[j]);
                const Eigen::Matrix3d pulled =
                    rest.area * byStrain(pulls[f].F, rest.b[i]) * moduliOf(f);
                Eigen::Matrix3d block = pulled * byStrain(pulls[f].F, rest.b[j]).transpose();
                block.diagonal().array() += along;
                H.add(cloth_.F(f, i), cloth_.F(f, j), block);
            }
        }
    });
}

void Membrane::addPairs(std::vector<std::pair<int, int>>& pairs) const {
    for (Eigen::Index f = 0; f < cloth_.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            pairs.emplace_back(cloth_.F(f, k), cloth_.F(f, (k + 1) % 3));
        }
    }
}

}  // namespace toile::sew
