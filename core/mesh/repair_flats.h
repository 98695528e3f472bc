// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/repair_gluing.h"

namespace toile {

/// Takes triangles without area out of a glued surface, so that neither hole nor T-junction opens.
/// The third vertex c of such a triangle lies on its longest side ab. Where a face abd is joined
/// there, the two become acd and cbd (an edge flip): abd is divided at a point of its own border,
/// and its area stays. On the border the triangle is dropped: ac and cb become border where ab was.
/// Components that are flat throughout are dropped.
///
/// The flat triangle with the longest side goes first. Its neighbour then is either no flat
/// triangle, and one flat triangle is gone; or it is flat with the same longest side, and the two
/// new ones are shorter. So this ends; only rounding could make it circle, and a budget stops that.
/// @param gluing  follows the changes; corners keep their vertices, see separateFans
/// @return whether anything changed; what is flat still, needs a collapse or another round
bool removeFlats(MeshPart& part, Gluing& gluing, RepairNotes& notes);

}  // namespace toile
