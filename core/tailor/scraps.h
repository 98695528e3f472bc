// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/tailor_seams.h"

namespace toile::tailor {

/// What of proposed lines is not to be cut beside cuts that are made anyhow: what runs along these,
/// and what would part a scrap of cloth from the rest, as where two lines meet a cut near its end.
/// @param cuts  ways of vertices, as those of the seams are
/// @return the seams that are left; one may come in several stretches
/// Cost: linear, for each turn in which scraps are joined; one or two do. Deterministic. Pure.
std::vector<TailorSeam> withoutScraps(const BodyWays& ways, const std::vector<TailorSeam>& seams,
                                      const std::vector<std::vector<int>>& cuts);

}  // namespace toile::tailor
