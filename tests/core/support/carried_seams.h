// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/assemble/seams_file.h"
#include "core/garment/garment.h"

namespace toile::test {

/// How the seams of one garment are drawn on another that is much like it.
struct Carrying {
    double farthest = 40;  ///< mm; where the other is farther away it has no seam
    double step = 10;      ///< mm, between the points by which a cut is drawn
    double shortest = 60;  ///< mm; what is left of a seam over a shorter way is left out
};

/// The seams of `from` as cuts of `onto`, by the places of its surface that are nearest to points
/// along them: where several seams meet so do the cuts, and a seam that runs off the surface ends
/// on its rim. Stretches along a rim are left out.
/// @param onto  one piece, uncut, in the axes and the scale of `from`
/// @return  in mm, as a seams file has them
SeamsFile carriedSeams(const Garment& from, const Garment& onto, const Carrying& how = {});

}  // namespace toile::test
