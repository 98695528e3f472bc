// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Pairs of outlines that share area, by (first, second). Outlines that touch, or overlap by less
/// than a thousandth of a millimetre, are left out: pieces are laid edge to edge on purpose.
/// @param outlines  closed, first point not repeated, mm; those with fewer than three points or
///                  coordinates that are not finite are ignored
/// Cost: n log n in the outlines whose boxes overlap, and in their edges that lie in both boxes.
/// Pure.
std::vector<std::pair<int, int>> overlappingOutlines(const std::vector<Points2>& outlines);

}  // namespace toile
