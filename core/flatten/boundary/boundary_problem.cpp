// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/boundary_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/flatten/boundary/boundary_kkt.h"
#include "core/geometry/segment.h"

namespace toile {

namespace detail {

Eigen::VectorXd spreadDeficit(const Eigen::VectorXd& angles) {
    const auto n = static_cast<double>(angles.size());
    return angles.array() + ((n - 2) * std::numbers::pi - angles.sum()) / n;
}

Eigen::VectorXd directionsOf(const Eigen::VectorXd& theta) {
    Eigen::VectorXd phi(theta.size());
    double turned = 0;
    for (int i = 0; i < theta.size(); ++i) {
        turned += std::numbers::pi - theta[i];
        phi[i] = turned;
    }
    return phi;
}

FlatBoundary closeOutline(const BoundaryProblem& problem, const Eigen::VectorXd& directions,
                          int iterations) {
    const int n = static_cast<int>(directions.size());
    FlatBoundary flat;
    flat.iterations = iterations;
    flat.points.resize(n, 2);
    flat.angles.resize(n);
    Eigen::RowVector2d at(0, 0);
    for (int i = 0; i < n; ++i) {
        flat.points.row(i) = at;
        at += problem.lengths[i] *
              Eigen::RowVector2d(std::cos(directions[i]), std::sin(directions[i]));
        const double before = i > 0 ? directions[i - 1] : directions[n - 1] - 2 * std::numbers::pi;
        flat.angles[i] = std::numbers::pi - directions[i] + before;
    }
    // The remaining gap is rounding; edges share it in proportion to their lengths.
    const double perimeter = problem.lengths.sum();
    flat.closureGap = at.norm() / perimeter;
    double along = 0;
    for (int i = 0; i < n; ++i) {
        flat.points.row(i) -= along / perimeter * at;
        along += problem.lengths[i];
    }
    flat.energy = 0.5 * (flat.angles - problem.angles).squaredNorm();
    return flat;
}

}  // namespace detail

namespace {

constexpr int kMaxPrograms = 500;
/// Size of the Lagrangian's gradient at which the iteration stops: angles in radians, closure
/// relative to the perimeter.
constexpr double kProgramTolerance = 1e-11;
constexpr double kRankTolerance = 1e-14;  ///< of the largest eigenvalue

using Constraints = Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Eq. (10) to (12): turning once, and closing in x and y.
Constraints constraintsAt(const BoundaryProblem& problem, const Eigen::VectorXd& phi) {
    const int n = static_cast<int>(phi.size());
    return {phi[n - 1] - 2 * std::numbers::pi, (problem.lengths.array() * phi.array().cos()).sum(),
            (problem.lengths.array() * phi.array().sin()).sum()};
}

/// Derivatives of the constraints with respect to theta; rows 2 and 3 are suffix sums, O(n).
Jacobian jacobianAt(const BoundaryProblem& problem, const Eigen::VectorXd& phi) {
    Jacobian A(3, phi.size());
    A.row(0).setConstant(-1);
    double suffixSin = 0;
    double suffixCos = 0;
    for (Eigen::Index i = phi.size() - 1; i >= 0; --i) {
        suffixSin += problem.lengths[i] * std::sin(phi[i]);
        suffixCos += problem.lengths[i] * std::cos(phi[i]);
        A(1, i) = suffixSin;
        A(2, i) = -suffixCos;
    }
    return A;
}

}  // namespace

Result<FlatBoundary> solveBoundarySlcp(const BoundaryProblem& problem, const Progress& progress) {
    Eigen::VectorXd theta = detail::spreadDeficit(problem.angles);
    Eigen::Vector3d lambda = Eigen::Vector3d::Zero();
    double size = 0;
    for (int iteration = 0; iteration <= kMaxPrograms; ++iteration) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const Eigen::VectorXd phi = detail::directionsOf(theta);
        const Constraints c = constraintsAt(problem, phi);
        const Jacobian A = jacobianAt(problem, phi);
        const Eigen::VectorXd gradient =
            problem.angles - theta - A.transpose() * lambda;  // B_theta, eq. (17)
        size = std::max(gradient.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>());
        if (!std::isfinite(size)) {
            break;
        }
        if (size <= kProgramTolerance) {
            return detail::closeOutline(problem, phi, iteration);
        }
        // Eq. (20): A A^T dlambda = A B_theta - B_lambda with B_lambda = -c. The pseudo-inverse
        // allows a rank of two (collinear outlines).
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> AAt(A * A.transpose());
        const Eigen::Vector3d inverse =
            (AAt.eigenvalues().array() > kRankTolerance * AAt.eigenvalues()[2])
                .select(AAt.eigenvalues().cwiseInverse(), 0);
        const Eigen::Vector3d step = AAt.eigenvectors() * inverse.asDiagonal() *
                                     AAt.eigenvectors().transpose() * (A * gradient + c);
        theta += gradient - A.transpose() * step;  // eq. (21)
        lambda += step;
    }
    return Error{
        ErrorCode::BoundaryNotConverged,
        {},
        worded("no solution after %1 steps, gradient %2", {figure(kMaxPrograms), shortest(size)})};
}

namespace {

Result<FlatBoundary> runSolver(const BoundaryProblem& problem, BoundarySolver solver,
                               const Progress& progress) {
    auto solved = solver == BoundarySolver::Newton ? solveBoundaryNewton(problem, progress)
                                                   : solveBoundarySlcp(problem, progress);
    if (solved) {
        solved->solver = solver;
    }
    return solved;
}

/// A vertex more than a quarter turn from its wanted angle may indicate a wrong minimum.
bool isPlausible(const Result<FlatBoundary>& solved, const BoundaryProblem& problem) {
    return solved
               ? (solved->angles - problem.angles).lpNorm<Eigen::Infinity>() <= std::numbers::pi / 2
               : solved.error().code == ErrorCode::Cancelled;
}

bool isClosed(const FlatBoundary& flat) {
    return flat.points.allFinite() && flat.closureGap <= kClosureTolerance;
}

}  // namespace

Result<FlatBoundary> solveBoundary(const BoundaryProblem& problem, BoundarySolver solver,
                                   const Progress& progress) {
    const double perimeter = problem.lengths.sum();
    if (!std::isfinite(perimeter) || !problem.angles.allFinite()) {
        return Error{ErrorCode::NotFinite, {}, worded("boundary lengths or angles are not finite")};
    }
    const double longest = problem.lengths.maxCoeff();
    if (!(longest < 0.5 * perimeter)) {
        return Error{ErrorCode::NoClosedOutline,
                     {},
                     worded("the edge is %1 long, the others together %2",
                            {shortest(longest), shortest(perimeter - longest)})};
    }
    // Lengths relative to the perimeter: one set of tolerances fits every scale.
    const BoundaryProblem scaled{problem.lengths / perimeter, problem.angles};
    auto solved = runSolver(scaled, solver, progress);
    if (!isPlausible(solved, scaled)) {
        const auto other =
            solver == BoundarySolver::Newton ? BoundarySolver::Slcp : BoundarySolver::Newton;
        auto second = runSolver(scaled, other, progress);
        if (second && (!solved || second->energy < solved->energy)) {
            solved = std::move(second);
        }
    }
    if (solved ? !isClosed(*solved) : solved.error().code == ErrorCode::BoundaryNotConverged) {
        solved = solveBoundaryDescent(scaled, progress);
    }
    if (!solved) {
        return solved.error();
    }
    if (!isClosed(*solved)) {
        return Error{ErrorCode::BoundaryNotConverged,
                     {},
                     worded("the outline stays open by %1 of its perimeter",
                            {shortest(solved->closureGap)})};
    }
    solved->points *= perimeter;
    return solved;
}

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
            "the edge is " + shortest(most) + " long, the others together " + shortest(others)};
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
