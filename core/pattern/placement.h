// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Where a copy of a flat piece lies on the sheet, in mm and radians: it is mirrored (x becomes -x)
/// where asked for, turned anti-clockwise about the origin of the piece's own coordinates, then
/// moved. The piece itself is never turned. Functions here are pure.
struct Placement {
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    double turn = 0;
    bool mirrored = false;  ///< the fabric's wrong side faces the reader

    Eigen::Vector2d applied(const Eigen::Vector2d& point) const {
        return offset + linear() * point;
    }

    /// The point of the piece that lies at a place of the sheet.
    Eigen::Vector2d undone(const Eigen::Vector2d& place) const {
        return linear().transpose() * (place - offset);  // orthogonal
    }

    Eigen::Matrix2d linear() const {
        const double c = std::cos(turn), s = std::sin(turn), x = mirrored ? -1 : 1;
        return (Eigen::Matrix2d() << x * c, -s, x * s, c).finished();
    }

    bool operator==(const Placement&) const = default;
};

/// mm from the origin: farther away nothing is laid.
inline constexpr double kFarthestOnSheet = 1e9;

/// The same direction in (-pi, pi]; 0 where the number is none.
double wrappedAngle(double angle);

/// Which way one point of the sheet lies from another; 0 where both are one place.
double directionTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

Placement movedBy(Placement placement, const Eigen::Vector2d& way);
/// Turned about a point of the sheet.
Placement turnedAbout(Placement placement, const Eigen::Vector2d& centre, double angle);

enum class Mirroring {
    LeftRight,   ///< across an upright line
    UpsideDown,  ///< across a level line
};

/// Reflected across a line of the sheet through `centre`: the other side of the fabric faces the
/// reader then.
Placement mirroredAt(Placement placement, const Eigen::Vector2d& centre, Mirroring mirroring);

/// A direction of the piece as it lies on the sheet, and back.
double directionOnSheet(const Placement& placement, double direction);
double directionOnPiece(const Placement& placement, double direction);

/// A line of the piece as it lies but for the offset: turned, and of a mirrored piece from its end
/// to its beginning, so that the cloth stays on the left. The very same points where nothing is
/// turned.
Points2 turnedLine(const Points2& line, const Placement& placement);

/// The outline of a piece where it lies on the sheet. @param Q  #V x 2, its flat coordinates
Points2 placedOutline(const Points2& Q, const std::vector<int>& boundary,
                      const Placement& placement);

/// The smallest upright box around an outline at its place; empty where there is no point.
/// @param outline  mm, in the piece's own coordinates
Eigen::AlignedBox2d outlineBox(const Points2& outline, const Placement& placement);

}  // namespace toile
