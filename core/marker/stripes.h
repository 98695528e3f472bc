// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/marker/laid_pieces.h"

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
