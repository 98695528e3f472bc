// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A short move after which an outline lies on none of the others and keeps `gap` from them; zero
/// where it does so already. Found in a fan of directions, in each the shortest path that bisection
/// finds: near the shortest there is, not the shortest itself. What lies in a hole of another lies
/// on it.
/// @param outline, others  closed, first point not repeated, mm; those of fewer than three points,
///                         or with coordinates that are no numbers, are in nobody's way
/// @param gap              mm, above 0
/// Deterministic. Cost: the outlines, thinned to a small part of the gap, edge by edge with those
/// of the neighbours, some hundred times: a few milliseconds. Pure.
Eigen::Vector2d moveToFreePlace(const Points2& outline, const std::vector<Points2>& others,
                                double gap);

}  // namespace toile
