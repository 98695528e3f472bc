// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/pattern/fair_outline.h"

namespace toile::fairing {

/// The quadratic programme of one Newton step of `fairLine`, along a closed line of n steps. Node j
/// moves by p_j, step j (from node j to the next) turns by phi_j, and kappa_j is the change of
/// curvature at node j:
///   minimise  sum of 1/2 bend_j (kappa_(j+1) - kappa_j + slope_j)^2 + 1/2 p_j^T hold_j p_j
///                    + force_j . p_j + 1/2 tension_j phi_j^2
///   subject to  p_(j+1) = p_j + lever_j phi_j + gap_j,  phi_(j+1) = phi_j + spacing_j kappa_(j+1),
///               kappa_(j+1) = given_j where node j + 1 is held;  all indices modulo n.
/// Lengths are in a unit in which waves of a few units matter (lambda), so that all states are of
/// similar size.

/// Matrix terms of step j and of the nodes at its ends.
struct KktStep {
    Eigen::Vector2d lever;
    double bend = 0;
    double spacing = 1;
    bool held = false;  ///< whether the turn at node j + 1 is fixed
    double tension = 0;
    Eigen::Matrix2d hold;
};

/// Right-hand side terms of step j and of the nodes at its ends.
struct KktRight {
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    double slope = 0;
    Eigen::Vector2d gap = Eigen::Vector2d::Zero();
    double given = 0;
};

struct KktMove {
    Eigen::Vector2d p;     ///< of node j
    double phi = 0;        ///< of step j
    double kappa = 0;      ///< at node j + 1
    Eigen::Vector2d pull;  ///< multiplier of gap_j: rate at which the minimum grows with it
    double torque = 0;     ///< multiplier of given_j; 0 where node j + 1 is free
};

/// Solves it by a Riccati recursion over the states x_j = (p_j, phi_j, kappa_j), from the last step
/// to the first. The cost-to-go is a quadratic function of x_j and of the four multipliers of x_n =
/// x_0; at the first state eight equations remain. Every pivot is a weight of one curvature, of
/// similar size along the line; elimination in directions alone has a condition number of (lambda /
/// h)^6. Cost: O(n), about 150 ns a step to factorise and 60 to solve; no heap after the first call
/// for an n. Re-entrant, one object per thread.
class CyclicKkt {
public:
    /// @param steps  one or more, of any inertia; if a pivot vanishes the moves are not finite
    void factorise(const std::vector<KktStep>& steps);
    /// Whether the moves are a minimum: then, by Haynsworth, pivots and last equations together
    /// have at most as many negative eigenvalues as x_n = x_0 has rows.
    bool isConvex() const { return negative_ <= 4; }
    /// @param right  one per step  @param moves  one per step, filled
    void solve(const std::vector<KktRight>& right, std::vector<KktMove>& moves) const;

    /// Twice the quadratic part of the objective at these moves, without slopes.
    double curvature(const std::vector<KktMove>& moves) const;

private:
    using State = Eigen::Vector4d;

    /// One step of the recursion, kept for right-hand sides.
    struct Link {
        State coupling;                          ///< of kappa_(j+1) with (p_(j+1), phi_j, kappa_j)
        State end;                               ///< of kappa_(j+1) with the multipliers of the end
        double weight;                           ///< of kappa_(j+1) alone, without bend
        double inverse;                          ///< of the pivot, weight + bend
        Eigen::Matrix<double, 4, 2> byPlace;     ///< of the state with p_(j+1)
        Eigen::Matrix<double, 4, 2> endByPlace;  ///< of the end with p_(j+1)
    };

    struct Ends;
    Ends sweepBack(const std::vector<KktRight>& right, std::vector<KktMove>& moves) const;
    void addMultipliers(const std::vector<KktRight>& right, const State& end,
                        std::vector<KktMove>& moves) const;

    std::vector<KktStep> steps_;
    std::vector<Link> links_;
    int negative_ = 0;
    Eigen::Matrix<double, 8, 8> closing_;  ///< inverse of the last eight equations
};

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

/// The iteration of `fairLine`: Newton steps on the Lagrangian, shortened until the merit of
/// objective and violation decreases, for increasing weights of fairness (`share` of lambda).
class FairSolver {
public:
    /// Keeps references.
    FairSolver(const FairModel& model, const Progress& progress)
        : model_(model), progress_(progress), state_(model.start()) {}

    /// Iterates at this weight until no direction changes by more than `done` (radians).
    /// @param limit  for `iterations()`, which counts over all weights
    /// @return false if it did not converge
    bool iterate(double share, double done, int limit);
    void restart();
    /// Moves the state onto the constraints with a small change. False if it cannot.
    bool restore(LineState& state);

    const LineState& state() const { return state_; }
    int iterations() const { return iterations_; }

private:
    bool findMoves(double share, bool convex);
    bool take(double share);
    void accept(LineState trial, double taken);
    void correct(LineState& state);

    const FairModel& model_;
    const Progress& progress_;
    LineState state_;
    double share_ = 0;  ///< weight for which the multipliers were computed
    CyclicKkt kkt_;
    std::vector<KktStep> steps_;
    std::vector<KktRight> right_, trialRight_;
    std::vector<KktMove> moves_, corrections_;
    double taken_ = 0;  ///< fraction of the last moves that was taken
    int iterations_ = 0;
};

}  // namespace toile::fairing
