// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/cyclic_kkt.h"
#include "core/pattern/fair_line.h"

namespace toile::fairing {

/// State of the solver; lengths in units of lambda, as in all of the model.
struct LineState {
    Eigen::VectorXd phi;  ///< directions of the steps, radians
    Points2 p;            ///< nodes; consistent with phi only at the solution
    Eigen::VectorXd z;    ///< multipliers of the tolerance: 1 / room at the solution
    Points2 pull;         ///< multipliers of the length constraints, by step
};

/// Objective and constraints of a `FairProblem`, and the terms of its Newton steps. Immutable;
/// everything is O(n).
class FairModel {
public:
    explicit FairModel(const FairProblem& problem);

    int count() const { return static_cast<int>(steps_.size()); }
    double perimeter() const { return steps_.sum(); }
    /// The reference with its directions.
    LineState start() const;

    /// 1 - d^2 / tol^2 at node j: positive within the tolerance.
    double room(const Points2& p, int j) const;
    /// The largest fraction of a move, at most 1, that leaves every node a twentieth of its room.
    double longestShare(const Points2& p, const std::vector<KktMove>& moves) const;
    /// The change of z_j that belongs to a move, before bounding.
    double dualMove(const LineState& state, const KktMove& move, int j) const;

    /// @param share  fraction of lambda in use  @return infinite outside the tolerance
    double objective(const LineState& state, double share) const;
    /// The derivative of the objective along a move.
    double slope(const std::vector<KktRight>& right, const std::vector<KktMove>& moves,
                 double share) const;
    /// Sum of the violations of steps and turns in the result of `writeConstraints`.
    double violation(const std::vector<KktRight>& right) const;
    /// The largest multiplier of a constraint.
    double largestMultiplier(const std::vector<KktMove>& moves) const;

    /// Matrix of the Newton step. @param convex  drop the compression of steps (negative tension)
    void writeMatrix(const LineState& state, double share, bool convex,
                     std::vector<KktStep>& steps) const;
    void writeGradients(const LineState& state, std::vector<KktRight>& right) const;
    void writeConstraints(const LineState& state, std::vector<KktRight>& right) const;

    /// The line along the directions from p_0, in mm; its closing error is spread over all steps.
    /// @param gap  the closing error as a fraction of the perimeter
    Points2 walked(const LineState& state, double& gap) const;

private:
    int next(int j) const { return j + 1 < count() ? j + 1 : 0; }
    double turn(const Eigen::VectorXd& phi, int j) const;
    double kappa(const Eigen::VectorXd& phi, int j) const { return turn(phi, j) / spacing_[j]; }

    double unit_;  ///< mm
    Points2 reference_;
    Eigen::VectorXd steps_, tolerance_;
    Eigen::VectorXd spacing_;  ///< of nodes: half the sum of their two steps
    Eigen::VectorXd bends_;    ///< of steps: 2 / h, 0 next to a corner
    std::vector<char> held_;   ///< of nodes: whether the turn is fixed
    Eigen::VectorXd wanted_;   ///< turns of held nodes
    Eigen::VectorXd first_;    ///< directions of the reference
    double round_ = 0;         ///< sum of all turns, a multiple of 2 pi
};

}  // namespace toile::fairing
