// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/seam_pull.h"

namespace toile::tailor {

/// Lines of the mesh that look like seams and are not found yet, like princess lines, yokes, bands
/// of necks and collars: long, likely, symmetric in the mirror plane, and extended to other lines
/// or rims.
/// @param known  ways of vertices
/// Cost: a search for each end of each. Deterministic.
std::vector<std::vector<int>> styleLines(const BodyWays& ways, const MeshLines& lines,
                                         const SeamPull& pull,
                                         const std::vector<std::vector<int>>& known);

}  // namespace toile::tailor
