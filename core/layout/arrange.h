// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace toile {

/// Aligns pieces on the sheet. Pure functions; mm, y up.

enum class Alignment { Left, Right, Top, Bottom, Centre, Middle };

/// The move of each box that aligns the named edge of all, or their horizontal (Centre) or vertical
/// (Middle) middle, with that of their common bounding box.
/// @param boxes  not empty
std::vector<Eigen::Vector2d> alignmentMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                            Alignment alignment);

enum class Direction { Across, Upwards };

/// The move of each box that makes the gaps between neighbours along the direction equal; the first
/// and the last stay. If the boxes do not fit, they overlap by equal amounts. Fewer than three
/// boxes do not move.
std::vector<Eigen::Vector2d> distributionMoves(std::span<const Eigen::AlignedBox2d> boxes,
                                               Direction direction);

}  // namespace toile
