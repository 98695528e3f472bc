// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/garment/fabric.h"
#include "core/layout/marker.h"

namespace toile {

/// Rows that keep to the cloth: how pieces lie that nobody has laid out yet. mm.

/// As without a cloth (marker.h), but that no row is wider than any cloth of those in it; a box
/// that is wider itself has a row of its own. So a ribbon's width is the limit of its own row
/// alone.
/// @param clothWidths  one per box, above 0; those of empty boxes are not looked at
Rows layOutInRows(std::span<const Eigen::AlignedBox2d> boxes, std::span<const double> clothWidths);

/// As without a fabric (marker.h), which takes the garment's own for one of the usual width.
/// @param whole  with the `Cutting` of each piece and the materials
LaidOutPattern laidOut(Pattern whole, const std::vector<std::optional<Placement>>& placements,
                       const Fabric& own);

}  // namespace toile
