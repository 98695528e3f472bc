// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

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

}  // namespace toile::fairing
