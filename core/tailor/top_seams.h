// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/seam_pull.h"

namespace toile::tailor {

/// Lines of one side of a top, each a path of vertices.
struct TopSide {
    std::vector<int> under;    ///< from the cuff past the armpit to the hem
    std::vector<int> ridge;    ///< from the neck to the cuff
    bool hasSleeve = true;     ///< false: the cuff is the armhole
    std::size_t armpit = 0;    ///< index into `under`; 0 without a sleeve
    std::size_t shoulder = 0;  ///< index into `ridge`; its end without a sleeve
    std::vector<int> armhole;  ///< closed: armpit, front, shoulder, back
};

/// @param side  -1 or 1: of the mirror plane
std::optional<TopSide> topSide(const BodyWays& ways, const SeamPull& pull, int side);

}  // namespace toile::tailor
