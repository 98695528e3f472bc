// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"
#include "core/tailor/tailor_seams.h"

namespace toile::tailor {

/// Makes smooth lines of ways along edges. Where a way follows a seam of the mesh it stays on its
/// edges. Elsewhere its teeth are taken out: it becomes the fewest shortest ways that stay near it,
/// and the kinks between them are rounded on the surface. Lines that meet share the point where
/// they do; a style line or a band ends on the others where these have come to run.
/// @param cuts  ways that are made anyhow: what meets them does so at their vertices
/// @return per seam points on the surface, joined by geodesics; of one that goes round the first is
///         not repeated
/// Cost: some shortest ways (`geodesicPath`) and dozens of shortenings (`straightened`) each.
/// Deterministic. Pure.
std::vector<std::vector<Eigen::Vector3d>> fairLines(const BodyWays& ways, const MeshLines& lines,
                                                    const std::vector<TailorSeam>& seams,
                                                    const std::vector<std::vector<int>>& cuts);

}  // namespace toile::tailor
