// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

namespace toile::nest {

using Rings = std::vector<geometry::Polygon>;

/// Whether the insides of two areas meet; to touch is not to meet. Exact for the coordinates as
/// they are. Each: an outline anti-clockwise, then its holes clockwise, none crossing another.
/// Cost: n m for the edges in the common part of their boxes. Pure.
bool doOverlap(const Rings& a, const Rings& b);

/// Whether rings cross themselves or each other; to touch is not to cross. Exact. No two points
/// next to each other are the same. Cost: the square of the points. Pure.
bool doRingsCross(const Rings& rings);

/// The rings with the winding that `doOverlap` expects.
Rings wound(Rings rings);

}  // namespace toile::nest
