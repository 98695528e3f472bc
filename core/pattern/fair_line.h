// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A closed line to make fair: near a reference, with steps of given lengths, and with a curvature
/// that changes as little as possible. With kappa_j the turn at node j over half the sum of its two
/// steps, and d_j its distance from the reference, over directions phi and points p
///   minimise  lambda^6 sum (kappa_(j+1) - kappa_j)^2 / h_j + sum (h_(j-1) + h_j)/2 psi(d_j),
///             psi(d) = -tol^2 log(1 - d^2 / tol^2),
///   subject to  p_(j+1) - p_j = h_j (cos phi_j, sin phi_j), and the turns of corners.
/// The first sum skips steps that touch a corner. Smooths waves shorter than about 2 pi lambda.
struct FairProblem {
    /// The line turns by `turn` = phi_node - phi_(node - 1), independent of the reference.
    struct Corner {
        int node = 0;
        double turn = 0;      ///< radians
        bool isFree = false;  ///< the line may turn there by any angle
    };
    /// No curvature at the nodes strictly between; `last` may exceed the node count (wraps around).
    struct Run {
        int first = 0, last = 0;
    };

    Points2 reference;              ///< #n x 2, mm: closed, anti-clockwise, first node not repeated
    Eigen::VectorXd steps;          ///< #n, mm: from node j to the next, kept exactly
    Eigen::VectorXd tolerance;      ///< #n, mm: node j stays nearer than this to its reference
    double smoothing = 40;          ///< lambda, mm
    std::vector<Corner> corners{};  ///< ascending by node
    std::vector<Run> straight{};    ///< where the reference is already straight
};

struct FairLine {
    Points2 points;              ///< #n x 2, mm
    Eigen::VectorXd directions;  ///< #n, radians: of the step after node j; not reduced
    int iterations = 0;
    double farthest = 0;    ///< mm: largest distance of a node from its reference
    bool converged = true;  ///< false: exact steps, but not the minimum; may exceed tolerance
};

/// Solves the problem by a primal-dual interior-point method with sequential quadratic programming:
/// Newton steps by `CyclicKkt`, each shortened until the merit of objective and violation
/// decreases. The chords of the reference may be slightly shorter than the steps. If the minimum is
/// not reached within kMaxFairIterations, or lengths, turns and tolerance contradict each other,
/// returns a line with exact steps and `converged` false; only a contradiction can exceed the
/// tolerance (`farthest`).
/// Preconditions: n >= 3 rows each; steps, tolerance and smoothing positive; smoothing up to about
/// 40 steps. Errors: NotFinite, Cancelled. Cost: O(n) an iteration, 6 to 30 of them. Re-entrant.
Result<FairLine> fairLine(const FairProblem& problem, const Progress& progress);

inline constexpr int kMaxFairIterations = 60;

}  // namespace toile
