// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/dirichlet_energy.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace toile::isometric {
namespace {

/// The derivative of det J by J: J's entries turned by a quarter.
Eigen::Matrix2d cofactors(const Eigen::Matrix2d& J) {
    Eigen::Matrix2d C;
    C << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
    return C;
}

using Vector4 = Eigen::Matrix<double, 4, 1>;
using Matrix4 = Eigen::Matrix<double, 4, 4>;

Vector4 asVector(const Eigen::Matrix2d& M) {
    return {M(0, 0), M(0, 1), M(1, 0), M(1, 1)};
}

/// Derivative of |J|^2 + |J^-1|^2 = I + I / D^2 by J, with I = |J|^2 and D = det J.
Eigen::Matrix2d stress(const Eigen::Matrix2d& J) {
    const double D = J.determinant();
    const double I = J.squaredNorm();
    return 2 * (1 + 1 / (D * D)) * J - 2 * I / (D * D * D) * cofactors(J);
}

/// Its second derivative, positive semidefinite.
Matrix4 stiffness(const Eigen::Matrix2d& J) {
    const double D = J.determinant();
    const double I = J.squaredNorm();
    const Vector4 j = asVector(J);
    const Vector4 c = asVector(cofactors(J));
    const double over2 = 1 / (D * D);
    const double over3 = over2 / D;
    Matrix4 H = 2 * (1 + over2) * Matrix4::Identity() -
                4 * over3 * (j * c.transpose() + c * j.transpose()) +
                6 * I * over2 * over2 * c * c.transpose();
    // Second derivative of det J: the constant matrix that pairs the corners of J.
    const double pairing = -2 * I * over3;
    H(0, 3) += pairing;
    H(3, 0) += pairing;
    H(1, 2) -= pairing;
    H(2, 1) -= pairing;
    // The twist: J's rotation turned by a quarter. The other three eigenvalues are positive.
    const double twist = 2 - 2 * (I - D) * over3;
    if (twist < 0) {
        const double cosine = 0.5 * (J(0, 0) + J(1, 1));
        const double sine = 0.5 * (J(1, 0) - J(0, 1));
        Vector4 t(-sine, -cosine, cosine, -sine);
        t /= std::sqrt(2.0) * std::hypot(cosine, sine);
        H -= twist * t * t.transpose();
    }
    return H;
}

}  // namespace

double SymmetricDirichlet::energy(const Points2& Q) const {
    double sum = 0;
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        const Eigen::Matrix2d J = jacobian(Q, f);
        const double D = J.determinant();
        if (!(D > 0)) {
            return std::numeric_limits<double>::infinity();
        }
        sum += shapes_[f].area * J.squaredNorm() * (1 + 1 / (D * D));
    }
    return 0.25 * sum;
}

Points2 SymmetricDirichlet::gradient(const Points2& Q) const {
    Points2 g = Points2::Zero(Q.rows(), 2);
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        addForces(f, 0.25 * shapes_[f].area * stress(jacobian(Q, f)), g);
    }
    return g;
}

void SymmetricDirichlet::addHessian(const Points2& Q, const std::vector<int>& edgeOf,
                                    linalg::BlockMatrix& hessian) const {
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        addBlocks(f, 0.25 * shapes_[f].area * stiffness(jacobian(Q, f)), edgeOf, hessian);
    }
}

double SymmetricDirichlet::starEnergy(const Points2& Q, std::span<const int> star) const {
    double sum = 0;
    for (const int f : star) {
        const Eigen::Matrix2d J = jacobian(Q, f);
        const double D = J.determinant();
        if (!(D > 0)) {
            return std::numeric_limits<double>::infinity();
        }
        sum += 0.25 * shapes_[f].area * J.squaredNorm() * (1 + 1 / (D * D));
    }
    return sum;
}

FlatEnergy::VertexModel SymmetricDirichlet::vertexModel(const Points2& Q, std::span<const int> star,
                                                        int v) const {
    VertexModel model;
    for (const int f : star) {
        const Shape& shape = shapes_[f];
        const int corner = mesh_.F(f, 0) == v ? 0 : mesh_.F(f, 1) == v ? 1 : 2;
        const Eigen::Vector2d b(shape.b[corner][0], shape.b[corner][1]);
        const Eigen::Matrix2d J = jacobian(Q, f);
        const double I = J.squaredNorm();
        const double D = J.determinant();
        const double over2 = 1 / (D * D);
        const double over3 = over2 / D;
        // How I / 2 and D change with the vertex; the second derivative of D is zero.
        const Eigen::Vector2d i = J * b;
        const Eigen::Vector2d d(J(1, 1) * b[0] - J(1, 0) * b[1], J(0, 0) * b[1] - J(0, 1) * b[0]);
        const double part = 0.25 * shape.area;
        model.energy += part * I * (1 + over2);
        model.gradient += part * (2 * (1 + over2) * i - 2 * I * over3 * d);
        model.stiffness += part * (2 * (1 + over2) * b.squaredNorm() * Eigen::Matrix2d::Identity() -
                                   4 * over3 * (i * d.transpose() + d * i.transpose()) +
                                   6 * I * over2 * over2 * d * d.transpose());
    }
    return model;
}

const EnergyKind kSymmetricDirichlet{
    "isotropic", false,
    [](const MeshArrays& mesh, const EdgeTable& table,
       const PieceCloth& /*cloth*/) -> std::unique_ptr<FlatEnergy> {
        return std::make_unique<SymmetricDirichlet>(mesh, table);
    }};

}  // namespace toile::isometric
