// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Parts the two sides of a cut where they overlap in the plane. Boundary vertices at one place in
/// space are mates; each goes into its own cloth by half of what is missing of a small gap. Lengths
/// change on the way, by little where the overlap is narrow against its length. Vertices that three
/// or more sides share stay.
/// @param Q  #V x 2, mm  @param gap  per boundary vertex, between it and its mate
/// Cost: n log n of the boundary.
void partCutSides(const Piece& piece, const Eigen::VectorXd& gap, Points2& Q);

}  // namespace toile
