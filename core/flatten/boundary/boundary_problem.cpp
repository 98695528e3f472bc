// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/boundary_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/base/text.h"
#include "core/base/tolerances.h"

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
        worded("not within %1 steps, gradient %2", {figure(kMaxPrograms), shortest(size)})};
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
                     worded("the edge has %1, the others together %2",
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
                     worded("closing gap %1 of the perimeter", {shortest(solved->closureGap)})};
    }
    solved->points *= perimeter;
    return solved;
}

}  // namespace toile
