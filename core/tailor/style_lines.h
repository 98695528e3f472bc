// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/seam_pull.h"

namespace toile::tailor {

/// Lines of the mesh that look like seams and lie on no line found so far, as princess lines,
/// yokes, bands of necks and collars: long, likely, the same on both sides of the mirror plane, and
/// led on to where other lines or rims are.
/// @param known  ways of vertices
/// Cost: a search for each end of each. Deterministic.
std::vector<std::vector<int>> styleLines(const BodyWays& ways, const MeshLines& lines,
                                         const SeamPull& pull,
                                         const std::vector<std::vector<int>>& known);

}  // namespace toile::tailor
