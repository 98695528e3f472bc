// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"
#include "core/pattern/curve_fit.h"
#include "core/pattern/pattern.h"

namespace toile {

/// One segment of a piece's seam line as curves, from end to end, computed on demand. If the
/// outline represents a curve (`isFine`), those of `fitCurves`, with a joint at corners that are no
/// turn points; else its straight edges. Their length is that of the segment in the plane, to
/// kCurveLengthTolerance.
/// @param outline  the piece's  @param segment  one of the piece's
/// Cost: linear in the segment, and that of `fitCurves`. Pure.
std::vector<CubicCurve> curvesOf(const PatternPiece& piece, const geometry::Line& outline,
                                 const PatternSegment& segment);

}  // namespace toile
