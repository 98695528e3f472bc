// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/disjoint_sets.h"
#include "core/io/soup.h"
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

/// Merges coinciding vertices within each object, by making faces refer to one of them; no vertex
/// is removed. If there are none, the soup stays the same pointer. A corner that then repeats its
/// neighbour is removed if three are left.
/// @param wanted       by the user: merges vertices within this distance, mm; 0: within a
///                     thousandth of the median edge. Empty: only changes a file of unconnected
///                     triangles, and only merges equal coordinates
/// @param millimetres  per unit of the file, for the message
/// @return a VerticesWelded note if anything was merged
/// Cost: linear on average; for a file that needs no change, its triangles and one count of their
/// corners.
Problems weldSoup(std::shared_ptr<const PolygonSoup>& soup, std::optional<double> wanted,
                  double millimetres, const std::string& name);

}  // namespace toile
