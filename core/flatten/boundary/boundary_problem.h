// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The boundary problem of [Wang05] eq. (9): among all closed planar outlines with the given edge
/// lengths, turning once, find one whose inner angles theta are closest to the wanted angles,
///   minimise 1/2 sum (theta_i - alpha_i)^2.
/// Edge i runs from vertex i to vertex i+1, anti-clockwise; vertex i is the start of edge i.
struct BoundaryProblem {
    Eigen::VectorXd lengths;  ///< n, any unit, positive
    Eigen::VectorXd angles;   ///< n, radians: alpha
};

/// A closed outline with the problem's lengths.
struct FlatBoundary {
    Points2 points;          ///< n x 2, unit of the lengths; the first vertex at the origin
    Eigen::VectorXd angles;  ///< n, radians: theta, not reduced modulo 2 pi
    BoundarySolver solver = BoundarySolver::Newton;  ///< the solver that found it
    int iterations = 0;
    double closureGap = 0;  ///< relative to the perimeter
    double energy = 0;      ///< 1/2 sum (theta - alpha)^2
};

/// Full Newton on the edge directions phi, where the objective is a tridiagonal quadratic form and
/// the constraints' second derivatives are diagonal: O(n) per step. Globalised: the curvature of
/// the constraints is reduced if the Hessian would have the wrong inertia, and a merit function
/// accepts the step.
/// Preconditions: n >= 3, positive finite lengths, finite angles.
/// Errors: NoClosedOutline, BoundaryNotConverged, NotFinite, Cancelled. Re-entrant.
Result<FlatBoundary> solveBoundaryNewton(const BoundaryProblem& problem, const Progress& progress);

/// Sequential linearly constrained programming, [Wang05] eq. (14) to (22), O(n) per step, starting
/// at alpha with the angle deficit spread evenly. Full steps, as in the paper: converges on
/// outlines that nearly close, without guarantee for others. Same preconditions and errors.
Result<FlatBoundary> solveBoundarySlcp(const BoundaryProblem& problem, const Progress& progress);

/// Fallback that cannot fail: starts at the convex polygon in a circle, which always exists and has
/// the lengths, and descends over closed outlines only; the wanted angles are approached in stages.
/// Slow; of several minima it finds the one the convex outline grows into. If it stops before the
/// minimum (outlines close to a line), the outline still has the lengths.
/// Same preconditions. Errors: NoClosedOutline, Cancelled. Cost: some hundred steps of O(n).
Result<FlatBoundary> solveBoundaryDescent(const BoundaryProblem& problem, const Progress& progress);

/// Chooses the solver, after checking that a closed outline exists. Neither is certain to converge
/// on outlines far from closing: if the wanted one fails, or leaves a vertex more than a quarter
/// turn from its wanted angle, the other runs too, and the outline of lower energy is used. If both
/// fail, the descent from the circle finds one, so every set of lengths that closes gets an
/// outline.
Result<FlatBoundary> solveBoundary(const BoundaryProblem& problem, BoundarySolver solver,
                                   const Progress& progress);

/// The convex polygon with the given edge lengths inscribed in a circle, anti-clockwise, edge i
/// from vertex i to i+1. It exists and is unique if every edge is shorter than all others together;
/// with one long edge the circle's centre lies outside. No three vertices are collinear.
/// @param lengths  n >= 3, positive  @return n x 2, unit of the lengths
/// Errors: NoClosedOutline. Cost: one scalar root, O(n) per step. Pure.
Result<Points2> circleOutline(const Eigen::VectorXd& lengths);

namespace detail {

/// Wanted angles plus the evenly spread deficit ((n-2) pi - sum alpha) / n: a start from which both
/// solvers also work on strongly curved pieces.
Eigen::VectorXd spreadDeficit(const Eigen::VectorXd& angles);

/// phi_i = sum over k <= i of (pi - theta_k): summing the turns instead of i*pi - sum theta
/// preserves precision on long outlines.
Eigen::VectorXd directionsOf(const Eigen::VectorXd& theta);

/// Newton's steps from given inner angles theta; otherwise like `solveBoundaryNewton`.
Result<FlatBoundary> newtonFrom(const BoundaryProblem& problem, const Eigen::VectorXd& theta,
                                const Progress& progress);

/// The outline along directions phi (phi_n included); the difference of its ends is the gap. The
/// gap, at rounding level once a solver has converged, is shared by all edges.
FlatBoundary closeOutline(const BoundaryProblem& problem, const Eigen::VectorXd& directions,
                          int iterations);

}  // namespace detail

}  // namespace toile
