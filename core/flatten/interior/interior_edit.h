// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linalg/edited_cholesky.h"
#include "core/mesh/weighted_edges.h"

namespace toile {

/// A weighted graph with held vertices: the unknowns of its Laplacian are the others.
struct HeldGraph {
    const WeightedEdges& graph;
    const std::vector<int>& unknown;  ///< of each vertex, -1 where it is held
    int count;                        ///< of the unknowns
};

/// How the Laplacian of one held graph comes from that of another.
struct InteriorEdit {
    MatrixEdit matrix;
    std::vector<int> row;  ///< of each unknown in the edited system: the old one, or an added one
};

/// Compares two Laplacians row by row.
/// @param vertexBefore  per vertex of `now` the one of `before` that it may be, or -1. Only a hint:
///                      a bad one gives a long edit, not a wrong one.
/// Differences of weights at rounding level are passed over. Cost: linear.
InteriorEdit editBetween(const HeldGraph& before, const HeldGraph& now,
                         const std::vector<int>& vertexBefore);

}  // namespace toile
