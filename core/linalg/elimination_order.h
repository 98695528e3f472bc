// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linalg/sparse_cholesky.h"

namespace toile {

/// Which unknowns of a sparse system are coupled: the neighbours of i are
/// neighbour[start[i]] .. neighbour[start[i + 1] - 1]. Symmetric, without i itself.
struct CouplingGraph {
    std::vector<int> start{0};
    std::vector<int> neighbour{};

    int size() const { return static_cast<int>(start.size()) - 1; }
};

/// Cost: linear.
CouplingGraph couplings(const SymmetricMatrix& matrix);

/// Nested dissection [Geo73]: an order of elimination that keeps the Cholesky factor of a surface
/// mesh small. The graph is halved again and again by separators, which come last. A separator is a
/// level of the distance, in edges, from one of a few far apart vertices (landmarks): of all such
/// levels near the middle of a part the smallest. Distances are counted along the surface, so that
/// folds that touch in space mislead nobody, and the levels' sizes are known without trying one.
/// Parts of two dozen unknowns are ordered by minimum degree.
/// @return which unknown to eliminate first, second, ...: a permutation, or empty where the graph
///         cannot be halved in this way (a few vertices are neighbours of nearly all)
/// Cost: O(n log n), on meshes of a million triangles a tenth of the factorisation. Pure.
std::vector<int> nestedDissection(const CouplingGraph& graph);

/// True where unknowns 2 v and 2 v + 1 are coupled with the same others, for every v: two unknowns
/// to each vertex of a graph. Cost: linear.
bool comesInPairs(const SymmetricMatrix& pattern);

/// The order for a system as they come from meshes: nested dissection for large ones. Empty
/// for small ones and for graphs that are no meshes, where minimum degree [ADD04] does better or
/// is cheaper.
std::vector<int> eliminationOrder(const SymmetricMatrix& pattern);

}  // namespace toile
