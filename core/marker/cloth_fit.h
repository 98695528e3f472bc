// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/fabric.h"
#include "core/marker/marker_plan.h"
#include "core/pattern/pattern.h"

namespace toile {

/// How the pieces of each material may lie, by material.
using ClothRules = std::map<std::string, MarkerSettings>;

/// Those of the plans: where copies were laid by hand says nothing of what fits.
ClothRules clothRules(const MarkerPlans& plans);

/// A piece that is wider than its cloth, or longer than its sheet, whichever way it may lie there.
struct WidePiece {
    int piece = 0;  ///< index into the garment's pieces; of a facing the piece it is copied from
    std::string facing{};  ///< its name; empty: it is the piece itself
    double extent = 0;     ///< mm, across the cloth or along the sheet, where it lies best
    double room = 0;       ///< mm: as much the cloth has, folded where it is, without its borders
};

/// What a marker leaves out because it is too large (`MarkerNester`), by material, then by piece.
/// Of hides, which have no width, nothing is said.
/// @param whole  `LaidOutPattern::wholePattern`, with grain and materials
/// @param own    of pieces that are of no material of their own
/// @param rules  of materials that are not in it nothing has been said
/// @param progress  looked at between pieces; cancelled, some are missing
/// Cost: that of `asCut`, and n log n in the points of outlines. Pure.
std::vector<WidePiece> widerThanCloth(const Pattern& whole, const Fabric& own,
                                      const ClothRules& rules,
                                      const Progress& progress = Progress());

}  // namespace toile
