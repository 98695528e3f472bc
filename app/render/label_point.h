// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A point of a flat piece far from its outline: where its name is written. It lies in a triangle,
/// so it is inside also for a crescent-shaped piece, whose centroid is not. Millimetres.
/// Cost: at most some hundred candidates times the outline.
Eigen::Vector2d labelPoint(const Points2& Q, const Triangles& F, const std::vector<int>& boundary);

/// Where the piece's grain arrow goes: where the name is; in a narrow piece, whose name would cover
/// the arrow, at the widest place near by. It lies in a triangle. Cost: as `labelPoint`.
Eigen::Vector2d arrowPoint(const Points2& Q, const Triangles& F, const std::vector<int>& boundary,
                           const Eigen::Vector2d& label);

}  // namespace toile
