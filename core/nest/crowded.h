// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/nest/search.h"

// For the sources of this folder only.
namespace toile::nest {

/// A nest on cloth that ends, for copies that laying one after the other found no room for: from
/// these poses, overlaps allowed, by separation. None where that has not found one after a while.
std::optional<Found> crowdedNest(const Problem& problem, const std::vector<Pose>& poses,
                                 const Progress& progress);

}  // namespace toile::nest
