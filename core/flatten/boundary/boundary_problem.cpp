// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/boundary_problem.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/text.h"
#include "core/base/tolerances.h"

namespace toile {

namespace detail {

Eigen::VectorXd spreadDeficit(const Eigen::VectorXd& angles) {
    const auto n = static_cast<double>(angles.size());
    return angles.array() + ((n - 2) * std::numbers::pi - angles.sum()) / n;
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
    // What is left at the end is rounding; every edge takes its share, in proportion to its length.
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

Result<FlatBoundary> runSolver(const BoundaryProblem& problem, BoundarySolver solver,
                               const Progress& progress) {
    auto solved = solver == BoundarySolver::Newton ? solveBoundaryNewton(problem, progress)
                                                   : solveBoundarySlcp(problem, progress);
    if (solved) {
        solved->solver = solver;
    }
    return solved;
}

/// A vertex more than a quarter turn from what is wanted may be the mark of a wrong minimum.
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
