// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/layout/placement.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Moving, turning, mirroring and lining up what lies on the sheet. Pure functions; millimetres,
/// radians anti-clockwise, y up.

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

/// The outline of a piece where it lies on the sheet. @param Q  #V x 2, its flat coordinates
Points2 placedOutline(const Points2& Q, const std::vector<int>& boundary,
                      const Placement& placement);

/// The smallest upright box around an outline at its place; empty where there is no point.
/// @param outline  mm, in the piece's own coordinates
Eigen::AlignedBox2d outlineBox(const Points2& outline, const Placement& placement);

enum class Alignment { Left, Right, Top, Bottom, Centre, Middle };

/// What moves each box so that all have the named edge, or their middle across (Centre) or upwards
/// (Middle), where the box around all has it.
/// @param boxes  none empty
std::vector<Eigen::Vector2d> alignmentMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                            Alignment alignment);

enum class Direction { Across, Upwards };

/// What moves each box so that the gaps between neighbours along the direction are the same; the
/// first and the last stay. Boxes that are longer than the room together overlap alike. Nothing
/// moves where there are fewer than three.
std::vector<Eigen::Vector2d> distributionMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                               Direction direction);

}  // namespace toile
