// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/garment/fabric.h"
#include "core/geometry/placement.h"
#include "core/pattern/pattern.h"

namespace toile {

/// A placed copy of a pattern piece.
struct PlacedCopy {
    int piece = 0;  ///< index into Pattern::pieces
    Placement placement{};
};

/// A pattern laid out: in [0, width] x [0, height], mm, y up.
struct Marker {
    std::vector<PlacedCopy> copies;  ///< one of each flat piece, in the pattern's order
    double width = 0, height = 0;
};

/// A pattern as it is cut (`asCut`), laid out: only drawn pieces take room.
struct LaidOutPattern {
    Pattern pattern;
    Marker marker;
    Pattern wholePattern;  ///< before `asCut`: all pieces whole, without facings
    Marker whole;          ///< layout of `wholePattern`, for UV maps
};

/// Places pieces as given, the lower left corner of all at (0, 0); those without a placement in
/// rows to the right of the others, or alone (`layOutInRows`).
/// @param placements  one per piece of the pattern, or empty
/// @param own  the garment's fabric, for pieces without a material  Cost: linear. Pure.
Marker placeCopies(const Pattern& pattern,
                   const std::vector<std::optional<Placement>>& placements = {},
                   const Fabric& own = fabricPresets().front());

/// The pattern as it is cut (`asCut`), and whole, both with their copies placed.
/// @param whole  with the `Cutting` of each piece and the materials
LaidOutPattern cutAndPlace(Pattern whole,
                           const std::vector<std::optional<Placement>>& placements = {},
                           const Fabric& own = fabricPresets().front());

/// 20 mm, or a tenth of the largest side of any piece if that is smaller, so that garments of any
/// scale keep their digits.
double gapBetweenPieces(double largestSide);

/// Moves of boxes to their places in rows, which fill [0, width] x [0, height].
struct Rows {
    std::vector<Eigen::Vector2d> offset;  ///< one per box; zero if the box is empty
    double width = 0, height = 0;
};

/// Lays boxes in rows, in their order, with a gap between them (`gapBetweenPieces`); boxes do not
/// overlap, and empty ones take no room.
/// @param clothWidths  one per box, above 0, mm: no row is wider than the narrowest cloth in it,
///                     except the row of a single box that is wider itself; empty boxes set no
///                     limit. Without widths there is no limit.
Rows layOutInRows(std::span<const Eigen::AlignedBox2d> boxes,
                  std::span<const double> clothWidths = {});

/// The same for the pieces of a pattern.
Rows layOutInRows(const Pattern& pattern);

}  // namespace toile
