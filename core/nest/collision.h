// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/shape.h"

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
