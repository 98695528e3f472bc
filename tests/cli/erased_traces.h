// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// The same surface without the traces that sewn panels leave in a mesh: three rounds of flipping
/// every other edge by chance, where that leaves the surface nearly as it is, and of moving inner
/// vertices halfway to the middle of their neighbours, along the surface. Same input, same output.
/// Precondition: oriented, manifold.
MeshArrays withoutTraces(MeshArrays mesh, unsigned seed);

}  // namespace toile::test
