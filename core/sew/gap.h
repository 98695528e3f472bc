// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/sew/cloth.h"
#include "core/sew/contact.h"

namespace toile::sew {

/// A value at a place of the cloth.
struct SpreadSample {
    double value;
    double area;   ///< area at rest that it represents
    int triangle;  ///< triangle of the place
};

/// Statistics of a value over cloth, by area at rest.
struct SpreadFigures {
    double mean = 0;
    double most95 = 0;  ///< exceeded by a twentieth of the area
    double max = 0;
    int place = -1;  ///< triangle with the largest value
};

/// All zero without area. n log n. Pure.
SpreadFigures spreadOf(std::vector<SpreadSample> samples);

/// Distances of sewn cloth from a surface, mm, unsigned: at its triangles' corners and middles from
/// the nearest point, weighted so that the mean of a quadratic function is exact.
/// n log n. Pure.
SpreadFigures gapTo(const WornSurface& surface, const Cloth& cloth, const Points3& X);

/// Gaps of the whole cloth, and of each piece.
struct ClothGaps {
    SpreadFigures whole;
    std::vector<SpreadFigures> pieces;  ///< size: `pieceCount(cloth)`
};

/// As `gapTo`, at the same cost.
ClothGaps gapsTo(const WornSurface& surface, const Cloth& cloth, const Points3& X);

/// Per triangle, the principal strain of larger absolute value, 1 is 100 %; positive is tension.
/// Linear. Pure.
std::vector<double> principalStrains(const Cloth& cloth, const Points3& X);

/// Statistics of the absolute values of `principalStrains`. n log n. Pure.
SpreadFigures strainOf(const Cloth& cloth, const Points3& X);

}  // namespace toile::sew
