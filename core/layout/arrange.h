// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace toile {

/// Lining up what lies on the sheet. Pure functions; mm, y up.

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
