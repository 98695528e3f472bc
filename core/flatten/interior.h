// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Places the interior of a piece by conformal (cotangent) weights with the boundary held:
/// sum_j w_ij (q_j - q_i) = 0 at every interior vertex, [DMA02] section 4. x and y are two right-
/// hand sides of one sparse Cholesky factorisation.
/// @param boundary  the loop; its i-th vertex is held at outline row i (mm)
/// @return #V x 2, mm
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled (checked before each stage). No
/// guarantee against flipped triangles: the outline is not convex in general. Cost: one
/// factorisation, two back-substitutions. Re-entrant.
Result<Points2> fillInterior(const MeshArrays& mesh, const EdgeTable& table,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress);

}  // namespace toile
