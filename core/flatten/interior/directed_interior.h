// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A graph with different weights per direction: column 0 is the weight of edges(e, 1) in the
/// equation of edges(e, 0), column 1 the reverse.
struct DirectedEdges {
    Edges edges;               ///< #E x 2
    Eigen::MatrixX2d weights;  ///< #E x 2
};

/// Mean value weights [Flo03] of the edges, on the surface:
///   w_ij = (tan(gamma / 2) + tan(delta / 2)) / |v_i - v_j|,
/// gamma and delta the angles at v_i adjacent to edge ij. Always positive, and exact in the plane:
/// a flat neighbourhood keeps its shape. Unit 1/length. Cost: linear. Pure.
/// Precondition: no degenerate triangles.
DirectedEdges meanValueWeights(const MeshArrays& mesh, const EdgeTable& table);

/// Solves sum_j w_ij (q_j - q_i) = 0 at every interior vertex, with different w_ij and w_ji, by an
/// LU factorisation (`InteriorSystem` for symmetric weights).
/// @param boundary  the loop of held vertices, in order  @param outline  #boundary x 2, any unit
/// @return #V x 2, unit of the outline
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled (checked before and after). Cost:
/// one sparse LU factorisation. Re-entrant.
Result<Points2> solveDirected(const DirectedEdges& graph, int vertexCount,
                              const std::vector<int>& boundary, const Points2& outline,
                              const Progress& progress);

/// Authalic (area keeping) weights of [DMA02], made unit-free by the mesh's mean squared edge
/// length m:
///   w_ij = m (cot gamma + cot delta) / |v_i - v_j|^2,
/// gamma and delta the angles at v_j adjacent to edge ij. Not symmetric; negative if gamma + delta
/// > pi. Exact in the plane, like the conformal ones. Cost: linear. Pure.
DirectedEdges authalicWeights(const MeshArrays& mesh, const EdgeTable& table);

/// Places the interior by [DMA02]'s mix of conformal and authalic weights, (1 - mu) w^C + mu w^A,
/// with the boundary held; w^C = cot a + cot b, without the half, has the same scale as w^A.
/// @param mu  in [0, 1]; 0 gives the result of `fillInterior`
/// @param boundary  the loop; its i-th vertex is held at outline row i (mm)
/// @return #V x 2, mm
/// Errors: FactorisationFailed, OutOfMemory, NotFinite, Cancelled. No guarantee against flipped
/// triangles. Cost: one sparse LU factorisation (Cholesky for mu = 0). Re-entrant.
Result<Points2> fillInteriorMixed(const MeshArrays& mesh, const EdgeTable& table,
                                  const std::vector<int>& boundary, const Points2& outline,
                                  double mu, const Progress& progress);

}  // namespace toile
