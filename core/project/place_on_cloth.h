// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/garment/fabric.h"
#include "core/project/place_pieces.h"

namespace toile {

/// As without a cloth (place_pieces.h), but that none of the first rows is wider than a cloth which
/// the pieces in it are cut from; what is said without one is of the usual width.
std::vector<PieceSettings> placedSettings(std::vector<PieceSettings> settings,
                                          const PieceResults& results,
                                          const std::vector<std::optional<FlatMotion>>& motions,
                                          const Pattern* pattern, const MaterialList& materials,
                                          const Fabric& own);

}  // namespace toile
