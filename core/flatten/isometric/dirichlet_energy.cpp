// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/dirichlet_energy.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "core/flatten/isometric/quadratic_roots.h"

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

SymmetricDirichlet::SymmetricDirichlet(const MeshArrays& mesh, const EdgeTable& table)
    : mesh_(mesh), table_(table), shapes_(static_cast<std::size_t>(mesh.F.rows())) {
    double whole = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
        const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
        // The triangle laid into the plane: corners (0, 0), (x1, 0), (x2, y2).
        const double x1 = a.norm();
        const double x2 = a.dot(b) / x1;
        const double y2 = a.cross(b).norm() / x1;
        Shape& shape = shapes_[f];
        shape.area = 0.5 * x1 * y2;
        shape.b[0][0] = -1 / x1;
        shape.b[0][1] = (x2 / x1 - 1) / y2;
        shape.b[1][0] = 1 / x1;
        shape.b[1][1] = -x2 / (x1 * y2);
        shape.b[2][0] = 0;
        shape.b[2][1] = 1 / y2;
        whole += shape.area;
    }
    for (Shape& shape : shapes_) {
        shape.area /= whole;
    }
}

Eigen::Matrix2d SymmetricDirichlet::jacobian(const Points2& Q, int f) const {
    const Shape& shape = shapes_[f];
    // Differences to the first corner keep the precision of a piece far from the origin.
    const Eigen::RowVector2d e1 = Q.row(mesh_.F(f, 1)) - Q.row(mesh_.F(f, 0));
    const Eigen::RowVector2d e2 = Q.row(mesh_.F(f, 2)) - Q.row(mesh_.F(f, 0));
    Eigen::Matrix2d J;
    for (int axis = 0; axis < 2; ++axis) {
        J(axis, 0) = e1[axis] * shape.b[1][0] + e2[axis] * shape.b[2][0];
        J(axis, 1) = e1[axis] * shape.b[1][1] + e2[axis] * shape.b[2][1];
    }
    return J;
}

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
        const Eigen::Matrix2d P = 0.25 * shapes_[f].area * stress(jacobian(Q, f));
        for (int k = 0; k < 3; ++k) {
            const double* b = shapes_[f].b[k];
            g(mesh_.F(f, k), 0) += P(0, 0) * b[0] + P(0, 1) * b[1];
            g(mesh_.F(f, k), 1) += P(1, 0) * b[0] + P(1, 1) * b[1];
        }
    }
    return g;
}

void SymmetricDirichlet::addHessian(const Points2& Q, const std::vector<int>& edgeOf,
                                    linalg::BlockMatrix& hessian) const {
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        const Matrix4 H = 0.25 * shapes_[f].area * stiffness(jacobian(Q, f));
        // Corner k moves J by q b_k^T: columns of B_k pair the axis with b_k.
        Eigen::Matrix<double, 4, 2> HB[3];
        for (int k = 0; k < 3; ++k) {
            const double* b = shapes_[f].b[k];
            HB[k].col(0) = H.col(0) * b[0] + H.col(1) * b[1];
            HB[k].col(1) = H.col(2) * b[0] + H.col(3) * b[1];
        }
        const auto block = [&](int row, int column) {
            const double* b = shapes_[f].b[row];
            Eigen::Matrix2d M;
            M.row(0) = b[0] * HB[column].row(0) + b[1] * HB[column].row(1);
            M.row(1) = b[0] * HB[column].row(2) + b[1] * HB[column].row(3);
            return M;
        };
        for (int k = 0; k < 3; ++k) {
            hessian.addVertex(mesh_.F(f, k), block(k, k));
            const int next = (k + 1) % 3;
            const bool rises = mesh_.F(f, k) < mesh_.F(f, next);
            hessian.addEdge(edgeOf[table_.faceEdges(f, k)],
                            rises ? block(next, k) : block(k, next));
        }
    }
}

double SymmetricDirichlet::largestStep(const Points2& Q, const Points2& P, double limit) const {
    double most = limit;
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        const Eigen::RowVector2d e1 = Q.row(mesh_.F(f, 1)) - Q.row(mesh_.F(f, 0));
        const Eigen::RowVector2d e2 = Q.row(mesh_.F(f, 2)) - Q.row(mesh_.F(f, 0));
        const Eigen::RowVector2d d1 = P.row(mesh_.F(f, 1)) - P.row(mesh_.F(f, 0));
        const Eigen::RowVector2d d2 = P.row(mesh_.F(f, 2)) - P.row(mesh_.F(f, 0));
        // Twice the area along the step: c + b t + a t^2, c > 0. Find its smallest positive root.
        const double a = d1.x() * d2.y() - d1.y() * d2.x();
        const double b = e1.x() * d2.y() - e1.y() * d2.x() + d1.x() * e2.y() - d1.y() * e2.x();
        const double c = e1.x() * e2.y() - e1.y() * e2.x();
        if (a * most * most + b * most + c > 0 && !(b < 0 && a > 0)) {
            continue;  // no root ahead: concave or rising all the way
        }
        for (const double root : quadraticRoots(a, b, c)) {
            if (root > 0 && root < most) {
                most = root;
            }
        }
    }
    return most;
}

}  // namespace toile::isometric
