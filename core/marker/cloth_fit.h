// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/fabric.h"
#include "core/marker/laid_pieces.h"
#include "core/marker/marker_settings.h"
#include "core/pattern/pattern.h"

// For the sources of this folder only.
namespace toile::cloth {

/// Gives the items with matched seams a place in the repeat, so that the two sides of a seam have
/// the same phase where it begins; limits these items to one angle.
/// @param laid  one per item  @param items  in the coordinates of `NestForm`
/// @param notes  gets seams that do not exist, do not match, or match at one end only
void matchStripes(const Pattern& pattern, const std::vector<LaidPiece>& laid,
                  const MarkerSettings& settings, std::vector<NestItem>& items,
                  std::vector<Wording>& notes);

}  // namespace toile::cloth

namespace toile {

/// How the pieces of each material may be laid, by material.
using ClothRules = std::map<std::string, MarkerSettings>;

/// The rules of the plans, without the manually placed copies.
ClothRules clothRules(const MarkerPlans& plans);

/// A piece that is wider than its cloth, or longer than its sheet, at every allowed angle.
struct WidePiece {
    int piece = 0;  ///< index into the garment's pieces; for a facing, the piece it is copied from
    std::string facing{};  ///< the facing's name; empty for the piece itself
    double extent = 0;     ///< mm, across the cloth or along the sheet, at the best angle
    double room = 0;       ///< mm: size of the cloth, after folding, without its borders
};

/// Finds the pieces that a marker leaves out because they are too large (`MarkerNester`), by
/// material, then by piece. Hides have no width and are not checked.
/// @param whole  `LaidOutPattern::wholePattern`, with grain and materials
/// @param own    fabric of pieces without a material
/// @param rules  materials without rules use the defaults
/// @param progress  polled between pieces; after a cancel some are missing
/// Cost: that of `asCut`, and n log n in the points of outlines. Pure.
std::vector<WidePiece> widerThanCloth(const Pattern& whole, const Fabric& own,
                                      const ClothRules& rules,
                                      const Progress& progress = Progress());

}  // namespace toile
