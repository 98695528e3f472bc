// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/sew/cloth.h"

namespace toile::sew {

/// A garment's pieces with what is sewn to what along its seams: as the two sides are matched, that
/// is by arc length with ease spread evenly. Where vertices of the two sides lie across from each
/// other they are sewn; where one has none across, the triangle there is divided at that place, in
/// space and in the pattern alike. Two closer than a twentieth of their edges count as across.
/// @param flat  per piece where each vertex is in the pattern, mm, warp along y; without points it
/// is left out  Cost: linear in the triangles, n log n in the seams. Pure. Errors: NoGeometry,
/// where no piece is flat.
Result<CutCloth> cutAlongSeams(const Garment& garment, const std::vector<Points2>& flat);

}  // namespace toile::sew
