// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

/// Decides when a descent factorises again and when it has converged, from the results of its
/// steps, never from the clock, so that the same input always takes the same path.
///
/// A step with the old factorisation is cheaper while it lowers the objective by more than the
/// average since then, including the cost of factorising. While steps keep their promises, a new
/// factorisation would do no better. All O(1).
class RefactorisationPolicy {
public:
    /// @param fresh  false if a factorisation exists at the start
    explicit RefactorisationPolicy(bool fresh = true) : fresh_(fresh) {}

    /// True if the next step needs a new factorisation.
    bool isFresh() const { return fresh_; }
    void renew() { fresh_ = true; }

    /// Counts a step.
    /// @param part      part of the step that was taken, above 0
    /// @param predicted  fall of the objective  @param fall  actual fall
    /// @param renewingCost  cost of a factorisation, in steps with an old one
    void count(double part, double predicted, double fall, double renewingCost);

    /// True if the last step, or all steps with one factorisation, lowered the objective by hardly
    /// more than `tolerance`, and single triangles did not stop them.
    bool hasArrived(double tolerance) const;

    /// True if single triangles stopped the last step.
    bool wasStopped() const;

private:
    bool fresh_;
    bool went_ = false;  ///< a step since the factorisation was not stopped
    double part_ = 0, fall_ = 0;
    double fallen_ = 0, spent_ = 0;  ///< since the factorisation; in steps with an old one
};

/// Curvature of the objective from the last steps of a descent, with which a factorisation that is
/// some steps old still gives good steps (L-BFGS, the two loops of [NW06] algorithm 7.4).
/// Cost: linear in the unknowns for each stored step.
class LbfgsHistory {
public:
    void clear() { steps_.clear(); }
    /// @param moved  change of the unknowns  @param turned  change of the gradient. A step along
    /// which the gradient fell is left out.
    void add(Points2 moved, Points2 turned);

    /// The first loop: subtracts the part of the gradient that the steps explain. Apply the old
    /// factorisation between the two loops. @return the subtracted parts, for the second loop
    std::vector<double> reduce(Points2& gradient) const;
    /// The second loop, on minus the inverse Hessian times the reduced gradient.
    void complete(const std::vector<double>& taken, Points2& step) const;

private:
    struct Step {
        Points2 moved, turned;
        double product;  ///< of the two, positive
    };

    std::vector<Step> steps_;  ///< oldest first
};

}  // namespace toile::isometric
