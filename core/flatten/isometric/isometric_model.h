// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/isometric_objective.h"

namespace toile {

/// Where a quadratic model of the isometric descent is laid out. Refers to what is the caller's.
struct ModelPoint {
    const Points2& Q;
    const IsometricObjective::Value& at;  ///< the objective there
    const Eigen::VectorXd& multipliers;   ///< of the boundary lengths
};

/// How stiff the augmented Lagrangian makes the length of each boundary edge: some ten thousand
/// times what the objective does there, so that each back-substitution lowers the violation of the
/// linearised lengths by about that factor. @param hessian  of the objective, one vertex held
Eigen::VectorXd lengthStiffness(const BlockMatrix& hessian, const EdgeLoops& loops);

/// Holds a vertex by a spring as stiff as it is itself: translations cost nothing, and this takes
/// their freedom and no other.
void addSpring(BlockMatrix& hessian, int v);

/// Makes the Hessian of the objective, one vertex held, the matrix of the augmented Lagrangian:
/// adds the boundary lengths with their stiffness, and a part of the diagonal.
/// @param regularisation  that part: rotations are nearly free
void addLengths(BlockMatrix& hessian, const LengthConstraints& constraints, const ModelPoint& point,
                const Eigen::VectorXd& stiffness, double regularisation);

}  // namespace toile
