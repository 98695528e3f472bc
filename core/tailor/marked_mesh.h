// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::tailor {

/// A surface of which some edges are marked.
struct MarkedMesh {
    MeshArrays mesh;
    EdgeTable table;
    std::vector<std::vector<int>>
        ways;  ///< the marked lines, as vertices; neighbours share an edge

    /// Per edge.
    std::vector<char> marks() const;
    /// Those on the lines.
    std::set<int> vertices() const;
};

/// The same surface with cuts as edges of it: split as `cutPieces` splits it, and closed again.
/// Vertices of the source keep their numbers. Cuts that cannot be made are left out, and what of
/// one runs along a rim or another cut.
/// @param mesh  oriented, manifold
/// Cost: that of tracing the cuts and of `cutAlong`. Cancelled, it is worth nothing. Deterministic.
/// Pure.
MarkedMesh markedMesh(const MeshArrays& mesh, const EdgeTable& table,
                      const std::vector<UserCut>& cuts, const Progress& progress);

}  // namespace toile::tailor
