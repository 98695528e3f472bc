// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/layout/marker.h"

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

/// Amount of one cloth needed for one of each piece in their current layout, warp upwards.
struct ClothNeed {
    std::string material;  ///< what these pieces are cut from; empty: the garment's own fabric
    double length = 0;     ///< along the warp, mm
    double across = 0;     ///< mm
    double width = 0;      ///< of the cloth (Fabric::width), mm

    bool fits() const { return across <= width; }
    bool operator==(const ClothNeed&) const = default;
};

/// One for each cloth that drawn pieces are cut from, the garment's own first, then by name;
/// includes allowances, if any. Cost: linear. Pure.
/// @param laid  with the `Cutting` of each piece and the materials
std::vector<ClothNeed> clothNeeds(const LaidOutPattern& laid, const Fabric& own);

/// "1072 mm of cloth 1400 mm wide ...", "the pieces lie 1500 mm wide, but the cloth is 1400 mm".
std::string sentence(const ClothNeed& need);

}  // namespace toile
