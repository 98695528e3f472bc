// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "piece.h"

namespace toile::samples {

/// Where a band is whole; its two ends meet on the other side.
enum class BandFold { Front, Back };

/// A narrow band around the garment, such as a neckband or a waistband.
struct Band {
    std::vector<SeamRun> seams;        ///< left side, centre front to centre back
    std::function<Vec3(double)> rise;  ///< from the seam line to the free edge, mm, over [0, 1]
    double width = 0.0;                ///< mm, about the length of `rise`
    double edge = 0.0;                 ///< edge length, mm
    BandFold fold = BandFold::Front;
};

/// Meshes the left half of the band and unfolds it. Both ends lie in the plane x = 0.
Piece makeBand(std::string name, const Band& band);

}  // namespace toile::samples
