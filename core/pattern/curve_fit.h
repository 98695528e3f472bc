// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/cubic_curve.h"

namespace toile {

inline constexpr double kCurveTolerance = 0.02;        // mm
inline constexpr double kCurveLengthTolerance = 0.01;  // mm, of a whole segment

/// A few cubic Bézier curves along a fine line from one turn point to the next, for drawings. They
/// run from its first to its last point, join at points of the line with a common tangent, and stay
/// within kCurveTolerance of it (and it of them); together they are `length` long to within
/// kCurveLengthTolerance. The distance may be greater only if the line bends so tightly that an arc
/// through its points leaves its chords by more (steps of 2 mm at a radius below 28 mm). A smooth
/// curve through the points would be longer than the chords, so least squares fit the lengths of
/// the handles to both distances and length (Gauss-Newton, with the points' parameters updated on
/// the way). A straight line becomes one curve with `isLine`. Each curve reaches as far as it can;
/// if the same number of curves can share the line evenly, they do.
/// @param line    #n x 2, mm, n >= 2: steps of about 2 mm, none of zero length
/// @param length  mm: the sum of the steps, which a fair line keeps exactly
/// Cost: about twenty fits per curve, each linear in its steps. Pure.
std::vector<CubicCurve> fitCurves(const Points2& line, double length);

}  // namespace toile
