// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/geometry/line.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A cubic Bézier curve in the plane, mm.
struct CubicCurve {
    Eigen::Vector2d start, startHandle, endHandle, end;
    bool isLine = false;  ///< handles at thirds of the straight line

    Eigen::Vector2d at(double t) const;          ///< t in [0, 1]
    Eigen::Vector2d derivative(double t) const;  ///< with respect to t
};

CubicCurve straightCurve(const Eigen::Vector2d& start, const Eigen::Vector2d& end);

/// Arc length by Gauss' rule on parts: to 1e-9 of the length if the curve turns by at most a right
/// angle. Pure.
double curveLength(const CubicCurve& curve);
double curveLength(const std::vector<CubicCurve>& chain);

/// Points on a chain of curves, evenly spaced by parameter, joints once.
/// @param perCurve  1 or more  @return (#curves * perCurve + 1) x 2; empty for no curve
Points2 sampled(const std::vector<CubicCurve>& chain, int perCurve);

/// An open line in fine steps, with properties of the smooth line that it represents: tangents,
/// lengths, and its distance from the chords. Immutable; keeps a reference to the points.
class FinePolyline {
public:
    /// @param points  #n x 2, mm, n >= 2, no two successive ones equal
    /// @param length  mm: length of the whole line; the steps get their shares of it
    FinePolyline(const Points2& points, double length);

    int count() const { return static_cast<int>(points_.rows()); }
    Eigen::Vector2d point(int k) const { return points_.row(k); }
    /// Tangent of the circle through a point and its neighbours; at the ends the curvature is
    /// extrapolated.
    const Eigen::Vector2d& tangent(int k) const { return tangents_[k]; }
    double length(int from, int to) const { return reached_[to] - reached_[from]; }
    /// Distance of an arc with the line's curvature from the chord of a step; 0 if the line bends
    /// to both sides.
    double sag(int step) const;

private:
    double curvature(int k) const { return 2 * turns_[k] / (steps_[k] + steps_[k - 1]); }
    bool isInside(int k) const { return k > 0 && k + 1 < count(); }
    double directionAt(int k) const;
    double directionAtEnd(int k) const;

    const Points2& points_;
    std::vector<double> steps_, directions_;  ///< of steps
    std::vector<double> turns_;               ///< at points; 0 at the ends
    std::vector<double> reached_;             ///< length from the first point to each point
    std::vector<Eigen::Vector2d> tangents_;
};

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

/// One segment of a piece's seam line as curves, from end to end, computed on demand. If the
/// outline represents a curve (`isFine`), those of `fitCurves`, with a joint at corners that are no
/// turn points; else its straight edges. Their length is that of the segment in the plane, to
/// kCurveLengthTolerance.
/// @param outline  the piece's  @param segment  one of the piece's
/// Cost: linear in the segment, and that of `fitCurves`. Pure.
std::vector<CubicCurve> curvesOf(const PatternPiece& piece, const geometry::Line& outline,
                                 const PatternSegment& segment);

}  // namespace toile
