// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/mesh/mesh_arrays.h"

// For the sources of this folder only.
namespace toile {

/// The garment with its vertices elsewhere: the same pieces by name, id and triangles, sewn at the
/// same places of the same edges. Sides of seams that are longer than each other by another part
/// than before are to be drawn by that of before (`Seam::drawn`), so that what was equally long
/// stays so.
/// @param positions  per piece: one per vertex, mm; none: it stays
/// Cost: linear. Pure.
Garment movedGarment(const Garment& garment, const std::vector<Points3>& positions);

}  // namespace toile
