// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/flatten/boundary/boundary_kkt.h"
#include "core/flatten/boundary/circle_outline.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using detail::DirectionProblem;
using detail::factoriseKkt;
using detail::Rows2;
using detail::Vector;

/// The wanted angles are approached in this many steps from those of the circle's polygon, so that
/// the outline found is one that the convex one grows into, not one wound up by a long step.
constexpr int kStages = 8;
constexpr int kStepsPerStage = 10;
constexpr int kStepsAtLast = 500;
/// No edge turns by more than this in a step, radians.
constexpr double kLongestTurn = 0.4;
constexpr double kDecreaseShare = 1e-4;
constexpr int kDescentHalvings = 50;
/// A closing gap (of the perimeter) that counts as closed within the descent.
constexpr double kClosed = 1e-14;
constexpr int kMaxClosingSteps = 20;
/// Below this size of the gradient plain Newton steps converge.
constexpr double kNear = 1e-7;

/// The directions of the convex polygon inscribed in a circle; its last edge points along +x.
Vector circleDirections(const Points2& circle) {
    const auto n = static_cast<int>(circle.rows());
    Vector phi(n - 1);
    double turned = 0;
    for (int i = 0; i + 1 < n; ++i) {
        const Eigen::RowVector2d in = circle.row(i) - circle.row((i + n - 1) % n);
        const Eigen::RowVector2d out = circle.row(i + 1) - circle.row(i);
        turned += turnBetween(in, out);
        phi[i] = turned;
    }
    return phi;
}

/// The closed outline next to `phi`: Newton's method on the two closing equations with the least
/// change of the angles. Nothing where it does not get there.
std::optional<Vector> closed(const DirectionProblem& problem, Vector phi) {
    double gap = problem.closure(phi).norm();
    for (int step = 0; step < kMaxClosingSteps && gap > kClosed; ++step) {
        const auto system = factoriseKkt(Vector::Zero(phi.size()), problem.jacobian(phi),
                                         /*withoutCurvature=*/true);
        if (!system) {
            return std::nullopt;
        }
        phi += system->solve(Vector::Zero(phi.size()), -problem.closure(phi)).first;
        const double after = problem.closure(phi).norm();
        if (!(after < gap)) {
            break;  // at the rounding floor, or astray
        }
        gap = after;
    }
    return gap <= 100 * kClosed ? std::optional(phi) : std::nullopt;
}

/// Goes down from one closed outline to the next until the gradient along them is small or no step
/// helps. The energy never rises, so that this ends at a stationary outline wherever it starts.
/// @param phi  the start; then where it ended  @return steps taken
int descend(const DirectionProblem& problem, Vector& phi, int steps, const Progress& progress) {
    Eigen::Vector2d lambda(0, 0);
    int step = 0;
    for (; step < steps && !progress.isCancelled(); ++step) {
        const Vector gradient = DirectionProblem::gradient(problem.residual(phi));
        const Rows2 J = problem.jacobian(phi);
        const auto system = factoriseKkt(problem.constraintCurvature(phi, lambda), J, false);
        if (!system) {
            break;
        }
        const auto [direction, multipliers] = system->solve(-gradient, -problem.closure(phi));
        lambda = multipliers;
        if ((gradient + J * lambda).lpNorm<Eigen::Infinity>() < kNear) {
            break;
        }
        const double before = problem.energy(phi);
        const double slope = std::min(gradient.dot(direction), 0.0);
        double share = std::min(1.0, kLongestTurn / direction.lpNorm<Eigen::Infinity>());
        bool accepted = false;
        for (int halving = 0; halving < kDescentHalvings && !accepted; ++halving, share *= 0.5) {
            const auto trial = closed(problem, phi + share * direction);
            if (trial && problem.energy(*trial) < before + kDecreaseShare * share * slope) {
                phi = *trial;
                accepted = true;
            }
        }
        if (!accepted) {
            break;
        }
    }
    return step;
}

}  // namespace

Result<FlatBoundary> solveBoundaryDescent(const BoundaryProblem& problem,
                                          const Progress& progress) {
    const auto circle = circleOutline(problem.lengths);
    if (!circle) {
        return circle.error();
    }
    Vector phi = circleDirections(*circle);
    const auto innerAngles = [&](const Vector& directions) {
        return Vector(DirectionProblem(problem).residual(directions) + problem.angles);
    };
    const Vector convex = innerAngles(phi);
    const Vector wanted = detail::spreadDeficit(problem.angles);
    if (auto closedStart = closed(DirectionProblem(problem), phi)) {
        phi = *closedStart;
    }
    int steps = 0;
    for (int stage = 1; stage <= kStages; ++stage) {
        const double share = static_cast<double>(stage) / kStages;
        const BoundaryProblem between{problem.lengths, (1 - share) * convex + share * wanted};
        steps += descend(DirectionProblem(between), phi,
                         stage < kStages ? kStepsPerStage : kStepsAtLast, progress);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const DirectionProblem directions(problem);
    FlatBoundary reached = detail::closeOutline(problem, directions.withLast(phi), steps);
    auto polished = detail::newtonFrom(problem, innerAngles(phi), progress);
    if (polished && polished->energy <= reached.energy * (1 + 1e-9)) {
        polished->iterations += steps;
        return polished;
    }
    return reached;
}

}  // namespace toile
