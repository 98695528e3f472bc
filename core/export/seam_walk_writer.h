// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/walk.h"

namespace toile {

/// "start", "notch" or "end": the station of a walk with this index.
std::string_view stationWord(const SeamWalk& walk, std::size_t station);

/// The results of walking the seams, as JSON (docs/patterns.md).
/// @param notches  per seam, those of the walks
std::string writeWalk(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks);

}  // namespace toile
