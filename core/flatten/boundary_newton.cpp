// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/LU>

#include "core/base/text.h"
#include "core/flatten/boundary_problem.h"

namespace toile {
namespace {

constexpr int kMaxIterations = 200;
/// Size of the gradient of the Lagrangian that counts as zero: radians, relative closure.
constexpr double kGradientTolerance = 1e-13;
/// Below this size a stalled iteration has reached the rounding floor of a long outline.
constexpr double kRoundingFloor = 1e-9;
/// Above this closing gap (of the perimeter) the constraints' curvature says nothing yet: following
/// it leads to outlines that wind wrongly.
constexpr double kFarFromClosed = 0.1;
constexpr double kSufficientDecrease = 1e-4;
constexpr int kMaxHalvings = 40;

using Vector = Eigen::VectorXd;
using Rows2 = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// The unknowns are phi_1 .. phi_(n-1); phi_0 = 0 and phi_n = 2 pi are given, so that the outline
/// turns once whatever the unknowns are.
struct Iterate {
    Vector phi;              ///< n - 1
    Eigen::Vector2d lambda;  ///< multipliers of closing in x and y
};

class NewtonProblem {
public:
    explicit NewtonProblem(const BoundaryProblem& problem)
        : problem_(problem), unknowns_(static_cast<int>(problem.lengths.size()) - 1) {}

    Vector start() const {
        const Vector theta = detail::spreadDeficit(problem_.angles);
        Vector phi(unknowns_);
        double turned = 0;
        for (int i = 0; i < unknowns_; ++i) {
            turned += std::numbers::pi - theta[i];
            phi[i] = turned;
        }
        return phi;
    }

    Vector withLast(const Vector& phi) const {
        Vector all(unknowns_ + 1);
        all << phi, 2 * std::numbers::pi;
        return all;
    }

    /// theta_i - alpha_i for i = 1 .. n.
    Vector residual(const Vector& phi) const {
        Vector r(unknowns_ + 1);
        double before = 0;
        for (int i = 0; i <= unknowns_; ++i) {
            const double here = i < unknowns_ ? phi[i] : 2 * std::numbers::pi;
            r[i] = (std::numbers::pi - (here - before)) - problem_.angles[i];
            before = here;
        }
        return r;
    }

    Eigen::Vector2d closure(const Vector& phi) const {
        const auto lengths = problem_.lengths.head(unknowns_).array();
        return {(lengths * phi.array().cos()).sum() + problem_.lengths[unknowns_],
                (lengths * phi.array().sin()).sum()};
    }

    static Vector gradient(const Vector& residual) {
        const Eigen::Index m = residual.size() - 1;
        return residual.tail(m) - residual.head(m);
    }

    /// Derivatives of the closure by phi, one row per unknown.
    Rows2 jacobian(const Vector& phi) const {
        const auto lengths = problem_.lengths.head(unknowns_).array();
        Rows2 J(unknowns_, 2);
        J.col(0) = -lengths * phi.array().sin();
        J.col(1) = lengths * phi.array().cos();
        return J;
    }

    /// Diagonal of the constraints' part of the Lagrangian's Hessian.
    Vector constraintCurvature(const Iterate& at) const {
        const auto lengths = problem_.lengths.head(unknowns_).array();
        return -lengths *
               (at.lambda.x() * at.phi.array().cos() + at.lambda.y() * at.phi.array().sin());
    }

private:
    const BoundaryProblem& problem_;
    int unknowns_;
};

/// L D L^T of the tridiagonal matrix with 2 + extra on the diagonal and -1 beside it.
class Tridiagonal {
public:
    explicit Tridiagonal(const Vector& extra) : pivots_(extra.size()) {
        for (Eigen::Index i = 0; i < extra.size(); ++i) {
            const double diagonal = 2 + extra[i];
            pivots_[i] = i > 0 ? diagonal - 1 / pivots_[i - 1] : diagonal;
            negative_ += pivots_[i] < 0 ? 1 : 0;
            smallest_ = std::min(smallest_, std::abs(pivots_[i]));
        }
    }

    int negativePivots() const { return negative_; }
    /// A pivot near zero says that the matrix is nearly singular or was eliminated unstably.
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
    std::pair<Vector, Eigen::Vector2d> solve(Vector a, const Eigen::Vector2d& b) const {
        H.solveInPlace(a);
        const Eigen::Vector2d mu = schur.fullPivLu().solve(J.transpose() * a - b);
        return {a - HinvJ * mu, mu};
    }
};

/// The KKT system at a point, with as much of the constraints' curvature as leaves the right
/// inertia: by Sylvester and Haynsworth, H has as many negative pivots as J^T H^-1 J has negative
/// eigenvalues. Without curvature (the SLCP model) H is positive definite, so the search ends.
std::optional<KktSystem> factoriseKkt(const Vector& curvature, const Rows2& J, bool far) {
    constexpr std::array kFading = {1.0, 0.75, 0.5, 0.25, 0.1, 0.0};
    for (const double share : kFading) {
        if (far && share > 0) {
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

/// Angle energy plus the closing gap, weighted so that no step may trade closure for energy.
struct Merit {
    const NewtonProblem& problem;
    double weight;

    double operator()(const Vector& phi) const {
        return 0.5 * problem.residual(phi).squaredNorm() +
               weight * problem.closure(phi).lpNorm<1>();
    }
};

/// Shortens the step until the merit decreases enough; a full step refused only because the
/// constraint bends away from its tangent gets a second-order correction first.
Vector searchAlong(const NewtonProblem& problem, const KktSystem& system, const Vector& phi,
                   const Vector& step, const Vector& gradient, const Eigen::Vector2d& closure,
                   double weight) {
    const Merit merit{problem, weight};
    const double before = merit(phi);
    const double slope = gradient.dot(step) - weight * closure.lpNorm<1>();
    const auto decreases = [&](const Vector& trial, double share) {
        return merit(trial) <=
               before + kSufficientDecrease * share * std::min(slope, 0.0) + 1e-15 * before;
    };
    if (decreases(phi + step, 1.0)) {
        return phi + step;
    }
    const Eigen::Vector2d bent = problem.closure(phi + step);
    const Vector corrected = phi + step + system.solve(Vector::Zero(phi.size()), -bent).first;
    if (decreases(corrected, 1.0)) {
        return corrected;
    }
    double share = 0.5;
    for (int halving = 0; halving < kMaxHalvings; ++halving, share *= 0.5) {
        if (decreases(phi + share * step, share)) {
            break;
        }
    }
    return phi + share * step;
}

}  // namespace

Result<FlatBoundary> solveBoundaryNewton(const BoundaryProblem& problem, const Progress& progress) {
    const NewtonProblem newton(problem);
    Iterate at{newton.start(), Eigen::Vector2d::Zero()};
    Iterate best = at;
    double bestSize = 1e300;
    double weight = 1;
    int iteration = 0;
    for (; iteration <= kMaxIterations; ++iteration) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
        const Vector gradient = NewtonProblem::gradient(newton.residual(at.phi));
        const Eigen::Vector2d closure = newton.closure(at.phi);
        const Rows2 J = newton.jacobian(at.phi);
        const double size = std::max((gradient + J * at.lambda).lpNorm<Eigen::Infinity>(),
                                     closure.lpNorm<Eigen::Infinity>());
        if (!std::isfinite(size)) {
            break;
        }
        const bool stalled = bestSize < kRoundingFloor && size > 0.5 * bestSize;
        if (size < bestSize) {
            best = at;
            bestSize = size;
        }
        if (size <= kGradientTolerance || stalled) {
            return detail::closeOutline(problem, newton.withLast(best.phi), iteration);
        }
        const auto system =
            factoriseKkt(newton.constraintCurvature(at), J, closure.norm() > kFarFromClosed);
        if (!system) {
            break;
        }
        const auto [step, lambda] = system->solve(-gradient, -closure);
        // Large enough for descent, and no longer than needed: a weight that only grows cuts every
        // later step short.
        weight = std::max(1 + 2 * lambda.lpNorm<Eigen::Infinity>(), 0.5 * weight);
        if (size < 1e-6) {  // inside the basin: the merit's rounding would only hinder
            at.phi += step;
        } else {
            at.phi = searchAlong(newton, *system, at.phi, step, gradient, closure, weight);
        }
        at.lambda = lambda;
    }
    return Error{
        ErrorCode::BoundaryNotConverged, "",
        "stopped after " + counted(iteration, "step") + ", gradient " + shortest(bestSize)};
}

}  // namespace toile
