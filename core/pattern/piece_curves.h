// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/cubic_curve.h"
#include "core/pattern/pattern.h"

namespace toile {

/// The seam line of a piece as curves, for files; both are found when they are asked for.

/// One segment, from end to end. Where the outline stands for a curve (`isFine`) those of
/// `fitCurves`, with a joint where it has a corner that is no turn point; else its straight edges.
/// As long as the segment is in the plane, to kCurveLengthTolerance.
/// @param segment  one of the piece's  Cost: linear in the outline, and that of `fitCurves`. Pure.
std::vector<CubicCurve> curvesOf(const PatternPiece& piece, const PatternSegment& segment);

/// A point of an outline, for formats that know no curves.
struct CurvePoint {
    Eigen::Vector2d point;
    bool isTurn = false;  ///< a turn point at which the line has a corner; else a curve point
};

/// The closed outline by few points of its curves: the ends of segments, and between them points on
/// the curves at even arc lengths, so many that the polygon is nowhere farther from the curves than
/// `deviation`; of a straight line only its ends. The first is not repeated.
/// @param deviation  mm, positive  Cost: that of `curvesOf` for each segment. Pure.
std::vector<CurvePoint> curvePoints(const PatternPiece& piece, double deviation);

}  // namespace toile
