// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/interior/directed_interior.h"
#include "core/mesh/edge_table.h"

namespace toile {

/// Authalic (area keeping) weights of [DMA02], made free of units by the mesh's mean
/// squared edge length m:
///   w_ij = m (cot gamma + cot delta) / |v_i - v_j|^2,
/// gamma and delta the angles at v_j beside edge ij. Not symmetric; negative where
/// gamma + delta > pi. Exact in the plane, like the conformal ones. Cost: linear. Pure.
DirectedEdges authalicWeights(const MeshArrays& mesh, const EdgeTable& table);

/// Places the interior by [DMA02]'s mix of conformal and authalic weights, (1 - mu) w^C + mu w^A,
/// with the boundary held; w^C = cot a + cot b, without the half, has the same scale as w^A.
/// @param mu  in [0, 1]; 0 gives what `fillInterior` gives
/// @param boundary  the loop; its i-th vertex is held at outline row i (mm)
/// @return #V x 2, mm
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. No guarantee against flipped
/// triangles. Cost: one sparse LU factorisation (Cholesky for mu = 0). Re-entrant.
Result<Points2> fillInteriorMixed(const MeshArrays& mesh, const EdgeTable& table,
                                  const std::vector<int>& boundary, const Points2& outline,
                                  double mu, const Progress& progress);

}  // namespace toile
