// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/sew/cloth.h"

namespace toile::sew {

/// A garment's pieces with the vertices to sew along its seams, matched like the two sides: by arc
/// length with ease spread evenly. Opposite vertices of the two sides are sewn. If a vertex has no
/// opposite vertex, the triangle there is split at that place, both in space and in the pattern.
/// Vertices closer than a twentieth of their edges count as opposite.
/// @param flat  per piece the pattern position of each vertex, mm, warp along y; a piece without
///              points is left out  Cost: linear in the triangles, n log n in the seams. Pure.
///              Errors: NoGeometry if no piece is flat.
Result<CutCloth> cutAlongSeams(const Garment& garment, const std::vector<Points2>& flat);

}  // namespace toile::sew
