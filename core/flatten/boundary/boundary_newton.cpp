// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/flatten/boundary/boundary_kkt.h"

namespace toile {
namespace {

using detail::DirectionProblem;
using detail::factoriseKkt;
using detail::KktSystem;
using detail::Rows2;
using detail::Vector;

constexpr int kMaxIterations = 200;
/// Size of the Lagrangian's gradient that counts as zero: radians, relative closure.
constexpr double kGradientTolerance = 1e-13;
/// Below this size a stalled iteration has reached the rounding floor of a long outline.
constexpr double kRoundingFloor = 1e-9;
/// Above this closing gap (of the perimeter) the constraints' curvature is misleading: following it
/// gives outlines with a wrong winding number.
constexpr double kFarFromClosed = 0.1;
constexpr double kSufficientDecrease = 1e-4;
constexpr int kMaxHalvings = 40;

struct Iterate {
    Vector phi;
    Eigen::Vector2d lambda;  ///< multipliers of closing in x and y
};

/// Angle energy plus the closing gap, weighted so that no step trades closure for energy.
struct Merit {
    const DirectionProblem& problem;
    double weight;

    double operator()(const Vector& phi) const {
        return problem.energy(phi) + weight * problem.closure(phi).lpNorm<1>();
    }
};

/// Shortens the step until the merit decreases enough; first tries a second-order correction if a
/// full step fails only because the constraint is curved.
Vector searchAlong(const DirectionProblem& problem, const KktSystem& system, const Vector& phi,
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
    Vector corrected = phi + step + system.solve(Vector::Zero(phi.size()), -bent).first;
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

namespace detail {

Result<FlatBoundary> newtonFrom(const BoundaryProblem& problem, const Eigen::VectorXd& theta,
                                const Progress& progress) {
    const DirectionProblem newton(problem);
    Iterate at{newton.directions(theta), Eigen::Vector2d::Zero()};
    Iterate best = at;
    double bestSize = 1e300;
    double weight = 1;
    int iteration = 0;
    for (; iteration <= kMaxIterations; ++iteration) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const Vector gradient = DirectionProblem::gradient(newton.residual(at.phi));
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
        const auto system = factoriseKkt(newton.constraintCurvature(at.phi, at.lambda), J,
                                         closure.norm() > kFarFromClosed);
        if (!system) {
            break;
        }
        const auto [step, lambda] = system->solve(-gradient, -closure);
        // Large enough for descent, but no larger than needed: a weight that only grows shortens
        // all later steps.
        weight = std::max(1 + 2 * lambda.lpNorm<Eigen::Infinity>(), 0.5 * weight);
        if (size < 1e-6) {  // inside the basin: rounding of the merit would only hinder
            at.phi += step;
        } else {
            at.phi = searchAlong(newton, *system, at.phi, step, gradient, closure, weight);
        }
        at.lambda = lambda;
    }
    return Error{
        ErrorCode::BoundaryNotConverged,
        {},
        "stopped after " + counted(iteration, "step") + ", gradient " + shortest(bestSize)};
}

}  // namespace detail

Result<FlatBoundary> solveBoundaryNewton(const BoundaryProblem& problem, const Progress& progress) {
    return detail::newtonFrom(problem, detail::spreadDeficit(problem.angles), progress);
}

}  // namespace toile
