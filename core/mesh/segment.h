// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <Eigen/Core>

namespace toile {

/// The cross product of two vectors of the plane: twice the signed area between them.
template <class A, class B>
double cross(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The point of a segment that is nearest to another point, as a share of the way from `a` to `b`:
/// 0 to 1, and 0 where both are one place. Of Eigen's vectors of any length, in columns or rows.
template <class Vector>
double nearestShare(const Vector& point, const Vector& a, const Vector& b) {
    const Vector edge = b - a;
    const double square = edge.squaredNorm();
    return square > 0 ? std::clamp((point - a).dot(edge) / square, 0.0, 1.0) : 0.0;
}

/// How far a point is from a segment, in the unit of both.
template <class Vector>
double distanceToSegment(const Vector& point, const Vector& a, const Vector& b) {
    return (a + nearestShare(point, a, b) * (b - a) - point).norm();
}

}  // namespace toile
