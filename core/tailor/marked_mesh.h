// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/user_cuts.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::tailor {

/// A surface with marked edges.
struct MarkedMesh {
    MeshArrays mesh;
    EdgeTable table;
    std::vector<std::vector<int>>
        ways;  ///< the marked lines, as vertices; neighbours share an edge

    /// Per edge: whether it is marked.
    std::vector<char> marks() const;
    /// The vertices on the lines.
    std::set<int> vertices() const;
};

/// The same surface with cuts as edges: split like `cutPieces` splits it, and closed again. Source
/// vertices keep their numbers. Cuts that cannot be made are left out, and so are parts along a rim
/// or another cut.
/// @param mesh  oriented, manifold
/// Cost: that of tracing the cuts and of `cutAlong`. After a cancel the result is invalid.
/// Deterministic. Pure.
MarkedMesh markedMesh(const MeshArrays& mesh, const EdgeTable& table,
                      const std::vector<UserCut>& cuts, const Progress& progress);

}  // namespace toile::tailor
