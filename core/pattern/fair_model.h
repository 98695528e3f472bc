// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/cyclic_kkt.h"
#include "core/pattern/fair_line.h"

namespace toile::fairing {

/// Where the solver stands; lengths in units of lambda, as in all of the model.
struct LineState {
    Eigen::VectorXd phi;  ///< directions of the steps, radians
    Points2 p;            ///< nodes: they follow from phi only at the solution
    Eigen::VectorXd z;    ///< multipliers of the tolerance: 1 / room at the solution
    Points2 pull;         ///< multipliers of the steps' lengths, of step j
};

/// Objective and constraints of a `FairProblem`, and what its Newton steps are made of. Immutable;
/// everything is O(n).
class FairModel {
public:
    explicit FairModel(const FairProblem& problem);

    int count() const { return static_cast<int>(steps_.size()); }
    double perimeter() const { return steps_.sum(); }
    /// On the reference, with its directions.
    LineState start() const;

    /// 1 - d^2 / tol^2 at node j: positive within the tolerance.
    double room(const Points2& p, int j) const;
    /// The longest share of a move, at most 1, that leaves every node a twentieth of its room.
    double longestShare(const Points2& p, const std::vector<KktMove>& moves) const;
    /// What the z follow a move with, before they are bounded.
    double dualMove(const LineState& state, const KktMove& move, int j) const;

    /// @param share  of lambda that is at work  @return infinite outside the tolerance
    double objective(const LineState& state, double share) const;
    /// The derivative of the objective along a move.
    double slope(const std::vector<KktRight>& right, const std::vector<KktMove>& moves,
                 double share) const;
    /// Sum of what steps and turns lack, as `writeConstraints` wrote it.
    double violation(const std::vector<KktRight>& right) const;
    /// The largest multiplier of a constraint.
    double largestMultiplier(const std::vector<KktMove>& moves) const;

    /// What the Newton step is made of. @param convex  without the steps' compression
    void writeMatrix(const LineState& state, double share, bool convex,
                     std::vector<KktStep>& steps) const;
    void writeGradients(const LineState& state, std::vector<KktRight>& right) const;
    void writeConstraints(const LineState& state, std::vector<KktRight>& right) const;

    /// The line along the directions from p_0 on, in mm; what it does not close by is shared by all
    /// steps. @param gap  what that was, of the perimeter
    Points2 walked(const LineState& state, double& gap) const;

private:
    int next(int j) const { return j + 1 < count() ? j + 1 : 0; }
    double turn(const Eigen::VectorXd& phi, int j) const;
    double kappa(const Eigen::VectorXd& phi, int j) const { return turn(phi, j) / spacing_[j]; }

    double unit_;  ///< mm
    Points2 reference_;
    Eigen::VectorXd steps_, tolerance_;
    Eigen::VectorXd spacing_;  ///< of nodes: half of the steps beside them
    Eigen::VectorXd bends_;    ///< of steps: 2 / h, 0 beside a corner
    std::vector<char> held_;   ///< of nodes
    Eigen::VectorXd wanted_;   ///< turns of held nodes
    Eigen::VectorXd first_;    ///< directions of the reference
    double round_ = 0;         ///< what all turns come to
};

}  // namespace toile::fairing
