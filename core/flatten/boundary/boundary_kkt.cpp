// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/boundary_kkt.h"

#include <array>
#include <numbers>

#include <Eigen/LU>

namespace toile::detail {

Vector DirectionProblem::withLast(const Vector& phi) const {
    Vector all(unknowns_ + 1);
    all << phi, 2 * std::numbers::pi;
    return all;
}

Vector DirectionProblem::residual(const Vector& phi) const {
    Vector r(unknowns_ + 1);
    double before = 0;
    for (int i = 0; i <= unknowns_; ++i) {
        const double here = i < unknowns_ ? phi[i] : 2 * std::numbers::pi;
        r[i] = (std::numbers::pi - (here - before)) - problem_.angles[i];
        before = here;
    }
    return r;
}

Eigen::Vector2d DirectionProblem::closure(const Vector& phi) const {
    const auto lengths = problem_.lengths.head(unknowns_).array();
    return {(lengths * phi.array().cos()).sum() + problem_.lengths[unknowns_],
            (lengths * phi.array().sin()).sum()};
}

Vector DirectionProblem::gradient(const Vector& residual) {
    const Eigen::Index m = residual.size() - 1;
    return residual.tail(m) - residual.head(m);
}

Rows2 DirectionProblem::jacobian(const Vector& phi) const {
    const auto lengths = problem_.lengths.head(unknowns_).array();
    Rows2 J(unknowns_, 2);
    J.col(0) = -lengths * phi.array().sin();
    J.col(1) = lengths * phi.array().cos();
    return J;
}

Vector DirectionProblem::constraintCurvature(const Vector& phi,
                                             const Eigen::Vector2d& lambda) const {
    const auto lengths = problem_.lengths.head(unknowns_).array();
    return -lengths * (lambda.x() * phi.array().cos() + lambda.y() * phi.array().sin());
}

Tridiagonal::Tridiagonal(const Vector& extra) : pivots_(extra.size()) {
    for (Eigen::Index i = 0; i < extra.size(); ++i) {
        const double diagonal = 2 + extra[i];
        pivots_[i] = i > 0 ? diagonal - 1 / pivots_[i - 1] : diagonal;
        negative_ += pivots_[i] < 0 ? 1 : 0;
        smallest_ = std::min(smallest_, std::abs(pivots_[i]));
    }
}

std::pair<Vector, Eigen::Vector2d> KktSystem::solve(Vector a, const Eigen::Vector2d& b) const {
    H.solveInPlace(a);
    const Eigen::Vector2d mu = schur.fullPivLu().solve(J.transpose() * a - b);
    return {a - HinvJ * mu, mu};
}

std::optional<KktSystem> factoriseKkt(const Vector& curvature, const Rows2& J,
                                      bool withoutCurvature) {
    constexpr std::array kFading = {1.0, 0.75, 0.5, 0.25, 0.1, 0.0};
    for (const double share : kFading) {
        if (withoutCurvature && share > 0) {
            continue;
        }
        KktSystem system{Tridiagonal(share * curvature), J, J, {}};
        if (!system.H.isSafe() || system.H.negativePivots() > 2) {
            continue;
        }
        system.H.solveInPlace(system.HinvJ);
        system.schur = J.transpose() * system.HinvJ;
        system.schur = (0.5 * (system.schur + system.schur.transpose())).eval();
        const double determinant = system.schur.determinant();
        const double trace = system.schur.trace();
        if (!std::isfinite(determinant) ||
            !(std::abs(determinant) > 1e-14 * system.schur.squaredNorm())) {
            continue;
        }
        const int negative = determinant < 0 ? 1 : (trace < 0 ? 2 : 0);
        if (negative == system.H.negativePivots()) {
            return system;
        }
    }
    return std::nullopt;
}

}  // namespace toile::detail
