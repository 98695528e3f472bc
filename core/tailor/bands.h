// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"

namespace toile::tailor {

/// Which of some lines set bands off, as of a neck, a cuff or a waist: all of such a line runs 15
/// to 65 mm beside the rim of an opening, and those beside one rim go nearly all round it.
/// @param ways  of vertices
/// @return per line
/// Cost: for each line and opening the product of their vertices. Pure.
std::vector<char> bandsAmong(const BodyWays& body, const std::vector<std::vector<int>>& ways);

/// The same lines of a mesh, of which those that set bands off look like no seam: an armhole is not
/// to be drawn to the border of a neck band. Cost: as above, for the likely ones.
MeshLines withoutBands(const BodyWays& body, MeshLines lines);

}  // namespace toile::tailor
