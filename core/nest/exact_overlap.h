// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

namespace toile::nest {

using Rings = std::vector<geometry::Polygon>;

/// Whether the interiors of two areas intersect; touching does not count. Exact for the given
/// coordinates. Each area: an outline anti-clockwise, then its holes clockwise, none crossing
/// another. Cost: n m for the edges in the common part of their boxes. Pure.
bool doOverlap(const Rings& a, const Rings& b);

/// Whether rings cross themselves or each other; touching does not count. Exact. Precondition: no
/// two neighbouring points are equal. Cost: quadratic in the points. Pure.
bool doRingsCross(const Rings& rings);

/// The rings with the winding that `doOverlap` expects.
Rings wound(Rings rings);

}  // namespace toile::nest
