// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "core/base/text.h"
#include "core/flatten/boundary/boundary_kkt.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using detail::DirectionProblem;
using detail::factoriseKkt;
using detail::Rows2;
using detail::Vector;

/// Number of steps from the circle polygon's angles to the wanted angles. With stages the convex
/// outline grows into the result; a long step could wind it up.
constexpr int kStages = 8;
constexpr int kStepsPerStage = 10;
constexpr int kStepsAtLast = 500;
/// No edge turns by more than this in a step, radians.
constexpr double kLongestTurn = 0.4;
constexpr double kDecreaseShare = 1e-4;
constexpr int kDescentHalvings = 50;
/// Relative closing gap (of the perimeter) that counts as closed within the descent.
constexpr double kClosed = 1e-14;
constexpr int kMaxClosingSteps = 20;
/// Plain Newton steps converge if the gradient is smaller than this.
constexpr double kNear = 1e-7;

/// The directions of the convex polygon inscribed in a circle; its last edge points along +x.
Vector circleDirections(const Points2& circle) {
    const auto n = static_cast<int>(circle.rows());
    Vector phi(n - 1);
    double turned = 0;
    for (int i = 0; i + 1 < n; ++i) {
        const Eigen::RowVector2d in = circle.row(i) - circle.row((i + n - 1) % n);
        const Eigen::RowVector2d out = circle.row(i + 1) - circle.row(i);
        turned += geometry::turnBetween(in, out);
        phi[i] = turned;
    }
    return phi;
}

/// The closed outline nearest to `phi`: Newton's method on the two closing equations with the
/// smallest change of the angles. Nothing if it does not converge.
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
            break;  // at the rounding floor, or diverging
        }
        gap = after;
    }
    return gap <= 100 * kClosed ? std::optional(phi) : std::nullopt;
}

/// Descends over closed outlines until the gradient along them is small or no step helps. The
/// energy never rises, so it ends at a stationary outline from any start.
/// @param phi  the start; then the end  @return steps taken
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

constexpr double kHalfTurn = std::numbers::pi;
constexpr int kMaxBisections = 1100;  // more than there are halvings of a double's range

/// Half the central angle of every edge if the longest edge's half is `half`, in (0, pi / 2]:
/// asin(r sin(half)) for the edge of relative length r, written so that no digits are lost if both
/// r and the sine are nearly one.
Eigen::VectorXd halfAngles(const Eigen::VectorXd& relative, double half) {
    const double sine = std::sin(half);
    const double cosine = std::cos(half);
    return relative.unaryExpr([&](double r) {
        const double rest = cosine * cosine + (1 - r) * (1 + r) * sine * sine;
        return std::atan2(r * sine, std::sqrt(rest));
    });
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

Result<Points2> circleOutline(const Eigen::VectorXd& lengths) {
    const auto n = static_cast<int>(lengths.size());
    int longest = 0;
    const double most = lengths.maxCoeff(&longest);
    double others = 0;
    for (int i = 0; i < n; ++i) {
        others += i == longest ? 0 : lengths[i];
    }
    if (!(most > 0 && most < others)) {
        return Error{
            ErrorCode::NoClosedOutline,
            {},
            "the edge has " + shortest(most) + ", the others together " + shortest(others)};
    }
    const Eigen::VectorXd relative = lengths / most;
    // Excess of the other edges over closing. With the centre inside, all halves sum to half a
    // turn. If they cannot, even in the smallest circle that holds the longest edge, the centre
    // lies beyond that edge, and its half is the sum of the others.
    const bool outside = halfAngles(relative, kHalfTurn / 2).sum() < kHalfTurn;
    const auto isBelow = [&](double half) {
        const Eigen::VectorXd halves = halfAngles(relative, half);
        return outside ? halves.sum() - halves[longest] > half : halves.sum() < kHalfTurn;
    };
    // Inside, the sum grows with the longest edge's half. Outside, the others exceed it in a flat
    // circle, where arcs are like chords, and fall below it at a quarter turn.
    double low = 0;
    double high = kHalfTurn / 2;
    for (int k = 0; k < kMaxBisections; ++k) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) {
            break;
        }
        (isBelow(middle) ? low : high) = middle;
    }
    Eigen::VectorXd halves = halfAngles(relative, 0.5 * (low + high));
    if (outside) {
        halves[longest] = kHalfTurn - halves[longest];  // its arc is the rest of the turn
    }
    // Walk edge by edge: each has its length to rounding, for any radius. An edge's direction turns
    // by its own half and its neighbour's. All edges share the remaining gap, including rounding.
    Points2 steps(n, 2);
    double direction = 0;
    for (int k = 0; k < n; ++k) {
        const int i = (longest + k) % n;
        steps.row(i) << lengths[i] * std::cos(direction), lengths[i] * std::sin(direction);
        direction += halves[i] + halves[(i + 1) % n];
    }
    const Eigen::RowVector2d gap = steps.colwise().sum();
    Points2 outline(n, 2);
    Eigen::RowVector2d at = Eigen::RowVector2d::Zero();
    for (int i = 0; i < n; ++i) {
        outline.row(i) = at;
        at += steps.row(i) - gap * (lengths[i] / (most + others));
    }
    return outline;
}

}  // namespace toile
