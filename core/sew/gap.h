// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/sew/cloth.h"
#include "core/sew/contact.h"

namespace toile::sew {

/// A figure at a place of the cloth.
struct SpreadSample {
    double value;
    double area;   ///< at rest that it stands for
    int triangle;  ///< where it is
};

/// A figure over cloth, by area at rest.
struct SpreadFigures {
    double mean = 0;
    double most95 = 0;  ///< what a twentieth of the area exceeds
    double max = 0;
    int place = -1;  ///< triangle where the largest is
};

/// All nought where there is no area. n log n. Pure.
SpreadFigures spreadOf(std::vector<SpreadSample> samples);

/// How far sewn cloth lies from a surface, mm, whichever side: distances of its triangles' corners
/// and middles from the nearest point, weighted so that a quadratic one has its exact mean.
/// n log n. Pure.
SpreadFigures gapTo(const WornSurface& surface, const Cloth& cloth, const Points3& X);

/// Of the whole, and of each piece alone.
struct ClothGaps {
    SpreadFigures whole;
    std::vector<SpreadFigures> pieces;  ///< `pieceCount(cloth)` of them
};

/// As `gapTo`, at the same cost.
ClothGaps gapsTo(const WornSurface& surface, const Cloth& cloth, const Points3& X);

/// Of each triangle the principal strain of larger size, a part of 1; above 0 it pulls. Linear.
/// Pure.
std::vector<double> principalStrains(const Cloth& cloth, const Points3& X);

/// How much it is strained: the sizes of `principalStrains`. n log n. Pure.
SpreadFigures strainOf(const Cloth& cloth, const Points3& X);

}  // namespace toile::sew
