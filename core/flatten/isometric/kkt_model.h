// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A quadratic model of the isometric descent, factorised: what a descent leaves behind for that of
/// a piece with the same triangles and nearly the same shape, whose first steps it serves as well
/// as its own last ones. Immutable: any number of threads may solve with it.
struct KktModel {
    std::shared_ptr<const SparseCholesky> factor;  ///< of the augmented Lagrangian
    Points2 directions;                            ///< of the boundary edges, where it was laid out
    Eigen::VectorXd stiffness;                     ///< of the boundary edges
};

}  // namespace toile
