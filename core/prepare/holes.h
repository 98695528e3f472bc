// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The rims that are holes in the cloth, and no openings: those up to a perimeter around which the
/// surface lies as a patch would, within 60 degrees on average. So the end of a sleeve, where cloth
/// stands across the opening, is none however narrow it is, and no outline of a small piece is.
/// @param largest  mm, perimeter
/// Cost: linear. Pure.
std::vector<RimLoop> findHoles(const MeshArrays& mesh, const EdgeTable& table, double largest);

/// How nearly the cloth beside a rim lies in the plane that a patch of it would: the mean cosine
/// between both along the rim. 1: a hole in a plane; 0: the end of a tube; -1: the outline of a
/// disk.
double flatness(const MeshArrays& mesh, const EdgeTable& table, const RimLoop& rim);

}  // namespace toile
