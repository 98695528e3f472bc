// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/marker/cloth_marker.h"

namespace toile::test {

/// A rectangle without one corner, which tells turned and mirrored apart; its id as given.
PatternPiece clothPiece(const std::string& name, double width, double height, std::uint64_t id);
Pattern clothPattern(std::vector<PatternPiece> pieces);

/// After so many rounds, on cloth of this width; expects that nothing is misplaced.
ClothMarker laidOn(double width, const Pattern& pattern, const MarkerSettings& settings = {},
                   const std::vector<KeptCopy>& kept = {}, int rounds = 1,
                   const std::string& material = {});

}  // namespace toile::test
