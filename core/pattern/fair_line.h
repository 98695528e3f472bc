// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A closed line to be made fair: near a reference, with steps of given lengths, and with a
/// curvature that changes as little as that allows. With kappa_j the turn at node j over half the
/// two steps beside it, and d_j its distance from the reference, over directions phi and points p
///   minimise  lambda^6 sum (kappa_(j+1) - kappa_j)^2 / h_j + sum (h_(j-1) + h_j)/2 psi(d_j),
///             psi(d) = -tol^2 log(1 - d^2 / tol^2),
///   subject to  p_(j+1) - p_j = h_j (cos phi_j, sin phi_j), and the turns of corners.
/// The first sum leaves out steps that touch a corner. Waves shorter than about 2 pi lambda go.
struct FairProblem {
    /// The line turns by `turn` = phi_node - phi_(node - 1), whatever the reference does.
    struct Corner {
        int node = 0;
        double turn = 0;      ///< radians
        bool isFree = false;  ///< the line may turn there by as much as it likes
    };
    /// No curvature at the nodes strictly between; `last` counts on past the last node.
    struct Run {
        int first = 0, last = 0;
    };

    Points2 reference;              ///< #n x 2, mm: closed, anti-clockwise, first node not repeated
    Eigen::VectorXd steps;          ///< #n, mm: from node j to the next, kept exactly
    Eigen::VectorXd tolerance;      ///< #n, mm: node j stays nearer than this to its reference
    double smoothing = 40;          ///< lambda, mm
    std::vector<Corner> corners{};  ///< ascending by node
    std::vector<Run> straight{};    ///< where the reference is straight already
};

struct FairLine {
    Points2 points;              ///< #n x 2, mm
    Eigen::VectorXd directions;  ///< #n, radians: of the step after node j; not reduced
    int iterations = 0;
    double farthest = 0;    ///< mm: largest distance of a node from its reference
    bool converged = true;  ///< false: exact, and near where that was possible, but not the fairest
};

/// Solves it by a primal-dual interior-point method with sequential quadratic programming: Newton
/// steps by `CyclicKkt`, each shortened until objective and violation together decrease. A
/// reference whose chords are a little shorter than the steps will do. Where the minimum is not
/// reached within kMaxFairIterations, or lengths, turns and tolerance contradict each other, a line
/// with exact steps comes back all the same, not converged; only in the last case may it leave the
/// tolerance (`farthest`).
/// Preconditions: n >= 3 rows each; steps, tolerance and smoothing positive; smoothing up to about
/// 40 steps. Errors: NotFinite, Cancelled. Cost: O(n) an iteration, 6 to 30 of them. Re-entrant.
Result<FairLine> fairLine(const FairProblem& problem, const Progress& progress);

inline constexpr int kMaxFairIterations = 60;

}  // namespace toile
