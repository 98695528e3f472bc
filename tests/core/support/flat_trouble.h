// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// Shapes that give a flattening trouble: outlines that fold over themselves, and slivers.
/// Millimetres. All are disks.

/// side x side squares of the saddle z = bend (x^2 - y^2) / size, slit from the middle of the lower
/// rim to the middle: the slit's two sides have vertices of their own at the same places and share
/// the tip. There is more than 2 pi around each point, so that the flat slit closes beyond its
/// sides. `side` is even.
MeshArrays saddleWithSlit(int side, double size, double bend);

/// A ruffle: the flat ring sector of `turnDegrees` (more than 360 too) between the radii `inner`
/// and `outer`, laid in `waves` waves around an axis without touching itself. A cone over a wavy
/// curve on the sphere, meshed along its rulings, hence exactly developable. Precondition:
/// turnDegrees is larger than what the way around the axis needs without waves (350).
MeshArrays flounce(double turnDegrees, double inner, double outer, int around, int across,
                   int waves = 5);

/// A bumpy square of squares `size` wide, every other row of them a thousand times as low as wide,
/// with diagonals chosen at random: angles next to 0 and to pi.
MeshArrays sliverGrid(int columns, int rows, double size, unsigned seed);

}  // namespace toile::test
