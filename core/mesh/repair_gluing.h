// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/repair_notes.h"
#include "core/mesh/repair_part.h"
#include "core/mesh/sides.h"

namespace toile {

/// Which sides of triangles are joined. Two sides may have the same ends and not be joined: while a
/// mesh is repaired, the gluing says what the surface is, and vertices follow it at last.
struct Gluing {
    std::vector<int> twin;          ///< per side: the side it is joined to, or -1 on the border
    std::vector<char> cutAtVertex;  ///< per vertex: ends an edge that was cut apart
    bool mayDouble = false;         ///< two edges of the surface may have the same two ends
};

/// How the faces lie in the connected parts of a gluing.
struct Sides {
    std::vector<int> component;  ///< per face, numbered by first face
    std::vector<char> turn;      ///< per face: to be turned to agree with most of the area
    std::vector<char> oneSided;  ///< per component: no turning can make it agree; nothing turns
    bool anyTurn = false;
};

/// Flood fill over joined sides. Where both ways have the same area, the first face stays.
Sides findSides(const MeshArrays& mesh, const std::vector<int>& twin);

/// Joins the two faces of every edge that has two. Where more meet, joins pairs from the best on:
/// the less a pair bends, the better. A pair that is joined nowhere else, by edges of two faces,
/// counts as bent by a right angle more, and so does one whose windings disagree (that one is not
/// joined at all where faces may not be turned). No pair is joined that would make a surface
/// one-sided that is not, apart from such edges. What finds no partner becomes border.
/// @param table  the edges of `mesh`
Gluing glue(const MeshArrays& mesh, const EdgeTable& table, bool mayTurn, RepairNotes& notes);

/// Turns the faces that look away from most of their component.
void turnWindings(MeshPart& part, Gluing& gluing, RepairNotes& notes);

}  // namespace toile
