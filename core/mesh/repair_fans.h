// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/repair_gluing.h"

namespace toile {

/// Gives every fan of joined faces a vertex of its own: the fan with the least corner keeps the
/// vertex, the others get copies, appended in order of their least corners. After this the mesh
/// itself says what the gluing said, but for what `splitDoubledEdges` does.
void separateFans(MeshPart& part, const Gluing& gluing, RepairNotes& notes);

/// Where a surface comes back to an edge's two vertices along another edge (a spiral around both,
/// or a flip that met an edge already there), indices alone would join the two. All but the first
/// such edge get a vertex in the middle, with source -1, and their faces are halved.
/// @return whether there were any
bool splitDoubledEdges(MeshPart& part, Gluing& gluing, RepairNotes& notes);

}  // namespace toile
