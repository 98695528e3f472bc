// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

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

}  // namespace toile
