// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The rims that are holes in the cloth and not openings: up to a perimeter, and with a surface
/// around them that lies like a patch, within 60 degrees on average. So neither the outline of a
/// small piece nor the end of a sleeve is a hole, however narrow: cloth stands across the opening.
/// @param largest  mm, perimeter
/// Cost: linear. Pure.
std::vector<RimLoop> findHoles(const MeshArrays& mesh, const EdgeTable& table, double largest);

/// How closely the cloth at a rim lies in the plane of a patch: the mean cosine between both along
/// the rim. 1: a hole in a plane; 0: the end of a tube; -1: the outline of a disk.
double flatness(const MeshArrays& mesh, const EdgeTable& table, const RimLoop& rim);

}  // namespace toile
