// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/polygon.h"

namespace toile::geometry {

/// A motion of the plane in mm and radians: points are mirrored if requested (x becomes -x), turned
/// anti-clockwise about the origin, then moved. It places a copy of a flat piece on the sheet; the
/// piece itself is never turned. Functions here are pure.
struct Placement {
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    double turn = 0;
    bool mirrored = false;  ///< the fabric's wrong side faces the reader

    Eigen::Vector2d applied(const Eigen::Vector2d& point) const {
        return offset + linear() * point;
    }
    Eigen::RowVector2d appliedToRow(const Eigen::RowVector2d& point) const {
        return applied(point.transpose()).transpose();
    }
    /// @param points  #n x 2
    Polygon appliedToRows(const Polygon& points) const {
        return (points * linear().transpose()).rowwise() + offset.transpose();
    }
    Placement inverse() const;

    /// The point of the piece at a place on the sheet.
    Eigen::Vector2d undone(const Eigen::Vector2d& place) const {
        return linear().transpose() * (place - offset);  // orthogonal
    }

    Eigen::Matrix2d linear() const {
        const double c = std::cos(turn), s = std::sin(turn), x = mirrored ? -1 : 1;
        return (Eigen::Matrix2d() << x * c, -s, x * s, c).finished();
    }

    bool operator==(const Placement&) const = default;
};

/// The motion that best maps `from` to `to` in the least-squares sense, point by point (the planar
/// Procrustes problem, solved in closed form). Points of no extent are only moved.
/// @param from, to  #n x 2, finite  @param mirrored  whether they are mirrored first
/// @param weights   #n, or empty: all equal
Placement fitMotion(const Polygon& from, const Polygon& to, bool mirrored = false,
                    const Eigen::VectorXd& weights = {});

/// mm from the origin; nothing is placed farther away.
inline constexpr double kFarthestOnSheet = 1e9;

/// The same direction in (-pi, pi]; 0 if the angle is not finite.
double wrappedAngle(double angle);

/// The direction from one point of the sheet to another; 0 if they coincide.
double directionTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

Placement movedBy(Placement placement, const Eigen::Vector2d& way);
/// Turned about a point of the sheet.
Placement turnedAbout(Placement placement, const Eigen::Vector2d& centre, double angle);

enum class Mirroring {
    LeftRight,   ///< across an upright line
    UpsideDown,  ///< across a level line
};

/// Reflected across a line of the sheet through `centre`: the other side of the fabric then faces
/// the reader.
Placement mirroredAt(Placement placement, const Eigen::Vector2d& centre, Mirroring mirroring);

/// Converts a direction of the piece to the sheet, and back.
double directionOnSheet(const Placement& placement, double direction);
double directionOnPiece(const Placement& placement, double direction);

/// A line of the piece as placed but without the offset: turned, and for a mirrored piece reversed,
/// so that the cloth stays on the left. Without a turn the points are returned exactly.
Polygon turnedLine(const Polygon& line, const Placement& placement);
/// The same, with the offset.
Polygon placedLine(const Polygon& line, const Placement& placement);

/// The outline of a piece as placed on the sheet. @param Q  #V x 2, its flat coordinates
Polygon placedOutline(const Polygon& Q, const std::vector<int>& boundary,
                      const Placement& placement);

/// The axis-aligned bounding box of a placed outline; empty if it has no point.
/// @param outline  mm, in the piece's own coordinates
Eigen::AlignedBox2d outlineBox(const Polygon& outline, const Placement& placement);

}  // namespace toile::geometry

namespace toile {

using geometry::directionTo, geometry::kFarthestOnSheet, geometry::Mirroring, geometry::outlineBox,
    geometry::placedLine, geometry::placedOutline, geometry::Placement, geometry::turnedLine,
    geometry::wrappedAngle;

}  // namespace toile

namespace toile::geometry {

/// Points in the plane relative to their centroid, evenly spaced along a closed line.
using CentredPlaces = std::vector<std::complex<double>>;

/// Correlation of two lists, the second starting at index `start` and wrapping around. Its angle is
/// the anti-clockwise turn that best aligns the second with the first; its size measures likeness.
/// The remaining squared distance is the sum of both `squaresOf` less twice this size.
/// Precondition: both have the same size.  Cost: linear. Pure.
std::complex<double> likeness(const CentredPlaces& ours, const CentredPlaces& theirs,
                              std::size_t start = 0);

/// Sum of the squared distances from the centroid.
double squaresOf(const CentredPlaces& places);

struct BestLikeness {
    std::complex<double> likeness = 0;
    std::size_t start = 0;
};
/// The start with the greatest likeness, the first of equals.  Cost: quadratic. Pure.
BestLikeness bestLikeness(const CentredPlaces& ours, const CentredPlaces& theirs);

}  // namespace toile::geometry
