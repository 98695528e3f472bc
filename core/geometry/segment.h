// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/geometry/polygon.h"
#include "core/geometry/triangle_tree.h"

namespace toile::geometry {

/// The cross product of two vectors of the plane: twice the signed area between them.
template <class A, class B>
double cross(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A quarter turn anti-clockwise.
inline Eigen::Vector2d leftOf(const Eigen::Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

/// The angle from one vector of the plane to another, anti-clockwise, in [-pi, pi]. Uses atan2,
/// like all angles: accurate for thin triangles, where acos loses half the digits.
template <class A, class B>
double turnBetween(const Eigen::MatrixBase<A>& from, const Eigen::MatrixBase<B>& to) {
    return std::atan2(cross(from, to), from.dot(to));
}

/// The angle between two vectors of the plane or of space, in [0, pi].
template <class A, class B>
double angleBetween(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    const typename A::PlainObject u = a;
    const typename B::PlainObject v = b;
    if constexpr (A::SizeAtCompileTime == 2) {
        return std::abs(turnBetween(u, v));
    } else {
        return std::atan2(u.cross(v).norm(), u.dot(v));
    }
}

/// The closest point of a segment to another point, as a share of the way from `a` to `b`: 0 to 1,
/// and 0 if both ends coincide. For Eigen vectors of any length, columns or rows.
template <class Vector>
double nearestShare(const Vector& point, const Vector& a, const Vector& b) {
    const Vector edge = b - a;
    const double square = edge.squaredNorm();
    return square > 0 ? std::clamp((point - a).dot(edge) / square, 0.0, 1.0) : 0.0;
}

/// The part of the segment from `from` to `from + way` inside an axis-aligned box, as shares of the
/// way: `first` > `last` if there is none.
struct ShareInBox {
    double first = 0, last = 1;
};
template <class Vector>
ShareInBox shareInBox(const Vector& from, const Vector& way, const Vector& low,
                      const Vector& high) {
    ShareInBox share;
    for (Eigen::Index axis = 0; axis < from.size(); ++axis) {
        const double before = low[axis] - from[axis], beyond = high[axis] - from[axis];
        if (way[axis] != 0) {
            const auto [enters, leaves] = std::minmax({before / way[axis], beyond / way[axis]});
            share = {std::max(share.first, enters), std::min(share.last, leaves)};
        } else if (before > 0 || beyond < 0) {
            return {1, 0};
        }
    }
    return share;
}

/// Distance of a point from a segment, in the unit of both.
template <class Vector>
double distanceToSegment(const Vector& point, const Vector& a, const Vector& b) {
    return (a + nearestShare(point, a, b) * (b - a) - point).norm();
}

/// On which side of the line from a to b the point c lies: 1 left of it (a, b, c anti-clockwise),
/// -1 right of it, 0 exactly on it. Exact for all finite coordinates whose products neither
/// overflow nor underflow (sizes between 1e-140 and 1e140): plain arithmetic if its error bound
/// allows, else the determinant as a sum of doubles without error ([She97]).
/// Cost: a few operations; about a hundred if the points are almost collinear. Pure.
int exactOrientation(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
                     const Eigen::RowVector2d& c);

/// Finds the points of a closed line in the plane that are closest to given points. Const use is
/// thread-safe. Cost: n log n in the line's points to build, log n per query.
class NearestOnLine {
public:
    /// @param closed  at least one point; its last is joined to its first
    explicit NearestOnLine(const Polygon& closed);

    /// The first along the line of equally close places.
    Eigen::RowVector2d operator()(const Eigen::RowVector2d& point) const;

private:
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> points_;
    TriangleTree<2, double> tree_;
};

}  // namespace toile::geometry
