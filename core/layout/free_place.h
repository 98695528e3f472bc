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

/// A short move after which an outline overlaps none of the others and keeps `gap` from them; zero
/// if it does so already. Searches a fan of directions, bisecting the distance in each: the result
/// is near the shortest, not exactly the shortest. Pieces in a hole of another overlap it.
/// @param outline, others  closed, first point not repeated, mm; those with fewer than three points
///                         or coordinates that are not finite are ignored
/// @param gap              mm, above 0
/// Deterministic. Cost: some hundred passes over the edges of the outlines, thinned to a small
/// fraction of the gap, and of their neighbours: a few milliseconds. Pure.
Eigen::Vector2d moveToFreePlace(const Points2& outline, const std::vector<Points2>& others,
                                double gap);

}  // namespace toile
