// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Conformal weight of each edge: half the sum of the cotangents of the angles opposite to it
/// ([DMA02] eq. 5 with the half of the Dirichlet energy). Scale-free. May be negative where those
/// angles sum to more than pi. Precondition: no degenerate triangles.
Eigen::VectorXd cotangentWeights(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
