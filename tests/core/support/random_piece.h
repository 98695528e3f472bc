// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// A random disk, the same for the same seed everywhere: about 30 to 600 triangles, a star-shaped
/// or wavy outline, jittered grid points with random diagonals or rings of random counts, on a
/// smooth surface of waves and bumps, weak or strong, or on a rough one (every vertex moved by up
/// to half an edge), of any size from thousandths to thousands. There are obtuse triangles,
/// slivers, edges across the piece that join two boundary vertices, and corners of a single
/// triangle.
MeshArrays randomPiece(unsigned seed);

}  // namespace toile::test
