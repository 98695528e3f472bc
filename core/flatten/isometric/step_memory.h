// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What the last steps of a descent told of the objective's curvature, by which a factorisation
/// that is some steps old still gives good steps (L-BFGS, the two loops of [NW06] algorithm 7.4).
/// Cost: linear in the unknowns for each step kept.
class StepMemory {
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

}  // namespace toile
