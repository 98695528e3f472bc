// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"

// For the sources of this folder only.
namespace toile {

/// Vertices after merging, at the position of the first of each set.
struct MergedVertices {
    Points3 V;
    std::vector<int> number;        ///< per vertex before: its new index
    std::vector<int> sourceVertex;  ///< `Piece::sourceVertex`, of the first that has one
};

/// @param same  one set per remaining vertex
/// @param sourceVertex  of all vertices, or empty if none has one
MergedVertices mergedVertices(const Points3& V, const std::vector<int>& sourceVertex,
                              geometry::DisjointSets& same);

}  // namespace toile
