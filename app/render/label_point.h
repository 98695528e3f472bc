// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// A point of a flat piece far from its edges: where its name is written. It lies in a triangle,
/// so it is inside also for a crescent-shaped piece, whose centroid is not. Millimetres.
/// @param piece  has no defect  @param Q  #V x 2
/// Cost: at most some hundred candidates times the edges.
Eigen::Vector2d labelPoint(const Piece& piece, const Points2& Q);

/// Where the piece's grain arrow goes: where the name is; in a narrow piece, whose name would cover
/// the arrow, at the widest place near by. It lies in a triangle. Cost: as `labelPoint`.
Eigen::Vector2d arrowPoint(const Piece& piece, const Points2& Q, const Eigen::Vector2d& label);

}  // namespace toile
