// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/mesh/mesh_arrays.h"

// Internal header of this folder.
namespace toile {

/// The garment with its vertices moved: the same pieces by name, id and triangles, sewn at the same
/// places of the same edges. If a move changes the length ratio of a seam's sides, the seam is
/// drawn with the ratio from before (`Seam::drawn`), so that equally long sides stay equal.
/// @param positions  per piece: one per vertex, mm; empty: the piece stays
/// Cost: linear. Pure.
Garment movedGarment(const Garment& garment, const std::vector<Points3>& positions);

}  // namespace toile
