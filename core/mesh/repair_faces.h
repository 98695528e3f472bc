// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/edge_table.h"
#include "core/mesh/repair_notes.h"
#include "core/mesh/repair_part.h"

namespace toile {

/// The repairs that need no neighbourhood: faces taken out, vertices made one.

/// Takes out faces on non-finite positions and faces that repeat a corner.
void dropUnusableFaces(MeshPart& part, RepairNotes& notes);

/// Makes the ends of every edge without length one vertex, the one of least index, and takes out
/// the faces that shrink to an edge by it. Without length: at most kDegenerateHeight of the
/// triangle's longest side, where no height could be larger; or a hundred times that where the
/// triangle has no height.
void collapseNeedles(MeshPart& part, RepairNotes& notes);

/// Of faces on the same three vertices, in whatever winding, keeps the first. Returns the edges of
/// what is left.
EdgeTable dropDuplicates(MeshPart& part, RepairNotes& notes);

}  // namespace toile
