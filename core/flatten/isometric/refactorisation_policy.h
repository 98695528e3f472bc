// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile::isometric {

/// Decides when a descent factorises anew, and when it has arrived, from what its steps bring;
/// never from the clock, so that the same input takes the same way.
///
/// As long as steps with the old factorisation lower the objective by more than the average since,
/// its own cost included, they are the cheaper way down; and where they keep their promises a new
/// one would do no better. All O(1).
class RefactorisationPolicy {
public:
    /// @param fresh  false where there is a factorisation to begin with
    explicit RefactorisationPolicy(bool fresh = true) : fresh_(fresh) {}

    /// True where the next step is to be with a new factorisation.
    bool isFresh() const { return fresh_; }
    void renew() { fresh_ = true; }

    /// Counts a step.
    /// @param part      of the step that was taken, above 0
    /// @param predicted  fall of the objective  @param fall  that came
    /// @param renewingCost  what a factorisation costs, in steps with an old one
    void count(double part, double predicted, double fall, double renewingCost);

    /// True where the last step, or all with one factorisation, brought hardly more than
    /// `tolerance`, and not because single triangles stopped them.
    bool hasArrived(double tolerance) const;

    /// True where the last step was stopped by single triangles.
    bool wasStopped() const;

private:
    bool fresh_;
    bool went_ = false;  ///< a step since the factorisation was not stopped
    double part_ = 0, fall_ = 0;
    double fallen_ = 0, spent_ = 0;  ///< since the factorisation; in steps with an old one
};

/// What the last steps of a descent told of the objective's curvature, by which a factorisation
/// that is some steps old still gives good steps (L-BFGS, the two loops of [NW06] algorithm 7.4).
/// Cost: linear in the unknowns for each step kept.
class LbfgsHistory {
public:
    void clear() { steps_.clear(); }
    /// @param moved  by how much the unknowns changed  @param turned  and the gradient with them.
    ///               A step along which the gradient fell is left out.
    void add(Points2 moved, Points2 turned);

    /// The first loop: takes off the gradient what the steps explain. Between the two the old
    /// factorisation is applied. @return what was taken, for the second loop
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
