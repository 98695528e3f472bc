// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/polygon.h"
#include "core/nest/shape.h"

namespace toile::nest {

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

// For the sources of this folder only.
namespace toile::nest {

/// Whether the interiors of two shapes intersect, the second one moved by (dx, dy); in floating
/// point, so it may err within rounding of their boundaries.
/// Cost: a few operations if their largest circles or their boxes decide, else linear in their
/// edges plus the product of those in the common part of their boxes. Pure.
bool doCollide(const Shape& a, const Shape& b, double dx, double dy);

/// How badly two shapes that collide do so, in mm^2 or so: by how deep their circles lie in each
/// other, with a tail outside, so that a search feels the way out ([GVW25]). Positive.
double collisionLoss(const Shape& a, const Shape& b, double dx, double dy);

}  // namespace toile::nest
