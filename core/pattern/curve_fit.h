// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/cubic_curve.h"

namespace toile {

inline constexpr double kCurveTolerance = 0.02;        // mm
inline constexpr double kCurveLengthTolerance = 0.01;  // mm, of a whole segment

/// Few cubic Bézier curves along a fine line from one turn point to the next, for drawings: from
/// its first point to its last, joined at points of the line with one tangent, nowhere farther from
/// it than kCurveTolerance (nor it from them), and together `length` long to within
/// kCurveLengthTolerance. Only where the line bends so tightly that an arc through its points would
/// stand farther off its chords (2 mm at a radius below 28 mm) the curves may do so too. A smooth
/// curve through the points would be longer than its chords: the lengths of the handles are found
/// by least squares for both, distances and length (Gauss-Newton, parameters of the points adjusted
/// on the way). A straight line is one curve with `isLine`. Each curve reaches as far as it can;
/// where the same number of curves can share the line evenly, they do.
/// @param line    #n x 2, mm, n >= 2: steps of about 2 mm, none of no length
/// @param length  mm: that of its steps, which a fair line keeps exactly
/// Cost: some twenty fits a curve, each linear in its steps. Pure.
std::vector<CubicCurve> fitCurves(const Points2& line, double length);

}  // namespace toile
