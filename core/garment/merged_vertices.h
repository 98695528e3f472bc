// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"

// For the sources of this folder only.
namespace toile {

/// Vertices of which several have become one, where the first of them was.
struct MergedVertices {
    Points3 V;
    std::vector<int> number;        ///< per vertex before: which it is now
    std::vector<int> sourceVertex;  ///< `Piece::sourceVertex`, of the first that has one
};

/// @param same  one set for each vertex that remains
/// @param sourceVertex  of all vertices, or empty: none has one
MergedVertices mergedVertices(const Points3& V, const std::vector<int>& sourceVertex,
                              geometry::DisjointSets& same);

}  // namespace toile
