// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "core/flatten/boundary/boundary_problem.h"

namespace toile::detail {

/// The boundary problem in edge directions, and the linear systems of its Newton steps. Used by all
/// solvers that work in directions; everything is O(n). Lengths are relative to the perimeter.

using Vector = Eigen::VectorXd;
using Rows2 = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// The unknowns are phi_1 .. phi_(n-1); phi_0 = 0 and phi_n = 2 pi are fixed, so that the outline
/// turns once for any unknowns. Keeps a reference to the problem.
class DirectionProblem {
public:
    explicit DirectionProblem(const BoundaryProblem& problem)
        : problem_(problem), unknowns_(static_cast<int>(problem.lengths.size()) - 1) {}

    /// The directions of an outline with these inner angles, which sum to (n - 2) pi.
    Vector directions(const Vector& theta) const { return directionsOf(theta).head(unknowns_); }
    Vector withLast(const Vector& phi) const;
    /// theta_i - alpha_i for i = 1 .. n.
    Vector residual(const Vector& phi) const;
    double energy(const Vector& phi) const { return 0.5 * residual(phi).squaredNorm(); }
    /// The sum of the edge vectors.
    Eigen::Vector2d closure(const Vector& phi) const;
    /// Gradient of the energy with respect to phi.
    static Vector gradient(const Vector& residual);
    /// Derivatives of the closure with respect to phi, one row per unknown.
    Rows2 jacobian(const Vector& phi) const;
    /// Diagonal of the constraints' part of the Lagrangian's Hessian.
    Vector constraintCurvature(const Vector& phi, const Eigen::Vector2d& lambda) const;

private:
    const BoundaryProblem& problem_;
    int unknowns_;
};

/// L D L^T of the tridiagonal matrix with 2 + extra on the diagonal and -1 next to it.
class Tridiagonal {
public:
    explicit Tridiagonal(const Vector& extra);

    int negativePivots() const { return negative_; }
    /// A pivot near zero means that the matrix is nearly singular or the elimination unstable.
    bool isSafe() const { return smallest_ > 1e-9; }

    template <class Right>
    void solveInPlace(Right& b) const {
        const Eigen::Index m = pivots_.size();
        for (Eigen::Index i = 1; i < m; ++i) {
            b.row(i) += b.row(i - 1) / pivots_[i - 1];
        }
        b.row(m - 1) /= pivots_[m - 1];
        for (Eigen::Index i = m - 2; i >= 0; --i) {
            b.row(i) = (b.row(i) + b.row(i + 1)) / pivots_[i];
        }
    }

private:
    Vector pivots_;
    int negative_ = 0;
    double smallest_ = 1e300;
};

/// A factorised KKT system  [H J; J^T 0]  with H positive definite on the constraints' null space.
struct KktSystem {
    Tridiagonal H;
    Rows2 J;
    Rows2 HinvJ;
    Eigen::Matrix2d schur;  ///< J^T H^-1 J

    /// Solves H p + J mu = a, J^T p = b.
    std::pair<Vector, Eigen::Vector2d> solve(Vector a, const Eigen::Vector2d& b) const;
};

/// The KKT system at a point, with as much of the constraints' curvature as gives the right
/// inertia: by Sylvester and Haynsworth, H has as many negative pivots as J^T H^-1 J has negative
/// eigenvalues. Without curvature (the SLCP model) H is positive definite, so the search ends;
/// nothing only if the constraints are dependent (an outline on a line).
/// @param withoutCurvature  use the SLCP model at once
std::optional<KktSystem> factoriseKkt(const Vector& curvature, const Rows2& J,
                                      bool withoutCurvature);

}  // namespace toile::detail
