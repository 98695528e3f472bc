// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/interior/directed_interior.h"
#include "core/mesh/edge_table.h"

namespace toile {

/// Mean value weights [Flo03] of the edges, taken on the surface:
///   w_ij = (tan(gamma / 2) + tan(delta / 2)) / |v_i - v_j|,
/// gamma and delta the angles at v_i beside edge ij. Always positive, and exact in the plane: a
/// flat neighbourhood keeps its shape. Unit 1/length. Cost: linear. Pure.
/// Precondition: no degenerate triangles.
DirectedEdges meanValueWeights(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
