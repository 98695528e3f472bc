// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sew/cloth.h"
#include "core/sew/contact.h"

namespace toile::sew {

/// A figure over cloth, by area at rest.
struct SpreadFigures {
    double mean = 0;
    double most95 = 0;  ///< what a twentieth of the area exceeds
    double max = 0;
    int place = -1;  ///< triangle where the largest is
};

/// How far sewn cloth lies from a surface, mm, whichever side: distances of its triangles' corners
/// and middles from the nearest point, weighted so that a quadratic one has its exact mean.
/// n log n. Pure.
SpreadFigures gapTo(const WornSurface& surface, const Cloth& cloth, const Points3& X);

/// How much it is strained: of each triangle the larger size of its two principal strains, a part
/// of 1. n log n. Pure.
SpreadFigures strainOf(const Cloth& cloth, const Points3& X);

}  // namespace toile::sew
