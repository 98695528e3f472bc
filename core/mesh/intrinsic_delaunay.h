// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The cotangent weights of the Delaunay triangulation of a surface.
struct IntrinsicDelaunay {
    /// The edges of the new triangulation, each pair of vertices once: the weights of parallel
    /// edges are summed; loops, which add nothing to a Laplacian, are omitted. Only weights of
    /// boundary edges can be negative, and no equation of an interior vertex contains them.
    WeightedEdges graph;
    int flips = 0;         ///< edges flipped; 0: the graph is the mesh's own
    bool complete = true;  ///< false if the limit of flips, or rounding, left negative weights
};

/// Flips edges within the surface, which keeps its shape, until the two angles opposite to every
/// interior edge sum to at most pi: the algorithm of [FSBS07] section 3. The result is the
/// Laplacian of the same surface with non-negative weights (a maximum principle), and of all its
/// triangulations the one with the smallest Dirichlet energy for any function. Triangles are laid
/// out in the plane in pairs instead of by lengths alone: the height of a needle, 1e-10 of its
/// length, is lost in the lengths of its sides.
/// @param mesh   a manifold, oriented surface with or without boundary, no degenerate triangle
/// @param table  its edges; boundary edges are not flipped
/// @errors Cancelled. Deterministic. Re-entrant.
/// Cost: linear plus the flips: a fifth of one per edge on usual meshes, 4 per edge on the most
/// stretched and sheared ones tried; some 0.4 us each. At most `kMaxFlipsPerEdge` per edge.
Result<IntrinsicDelaunay> intrinsicDelaunay(const MeshArrays& mesh, const EdgeTable& table,
                                            const Progress& progress);

/// Far more than any mesh has needed: only guarantees termination.
inline constexpr int kMaxFlipsPerEdge = 200;

}  // namespace toile
