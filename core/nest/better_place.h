// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/nest/lay.h"
#include "core/nest/random.h"

// For the sources of this folder only.
namespace toile::nest {

/// How wide a copy looks, before the best places are refined by descent along one way after the
/// other, for a better place ([GVW25]).
struct PlaceSearch {
    int anywhere = 50;  ///< places tried in the whole strip
    int around = 25;    ///< and within the present box
};

/// Moves a copy to the best place found, where that is better than the present one.
/// @param evaluations  counts the places that were looked at
void findBetterPlace(Lay& lay, std::size_t copy, const PlaceSearch& search, Random& random,
                     std::int64_t& evaluations);

}  // namespace toile::nest
