// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sew/cloth.h"

namespace toile::test {

/// Cloth that is cut and sewn without any strain, in the triangles of the shape it makes. The
/// shape's outer side is that from which triangles run anti-clockwise. Millimetres.

/// A rectangle in the plane z = 0, warp along y: columns x rows squares of `size`.
sew::CutCloth flatCloth(int columns, int rows, double size);
/// A rectangle rolled up around the y axis and sewn along its sides.
sew::CutCloth tubeCloth(int columns, int rows, double radius, double height);
/// A sector rolled up to a cone about the y axis that opens downwards, its tip cut off: from
/// `inner` to `outer` along the slant.
sew::CutCloth coneCloth(int columns, int rows, double inner, double outer, double slope);
/// Six squares of side x side squares each, sewn to a cube around the origin.
sew::CutCloth cubeCloth(int side, double size);

/// The points moved along a direction of their own, at most `far` mm, the same for the same seed.
Points3 shaken(const Points3& X, double far, unsigned seed);

}  // namespace toile::test
