// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/marker/laid_pieces.h"

// For the sources of this folder only.
namespace toile::cloth {

/// Gives the items whose seams are matched a place in the repeat, so that where a seam begins its
/// two sides lie alike in it; these are turned one way only.
/// @param laid  one per item  @param items  in the coordinates of `NestForm`
/// @param notes  seams that are not there, that are not kept, or that are kept at one end only
void matchStripes(const Pattern& pattern, const std::vector<LaidPiece>& laid,
                  const MarkerSettings& settings, std::vector<NestItem>& items,
                  std::vector<Wording>& notes);

}  // namespace toile::cloth
