// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/marker/cloth_marker.h"

namespace toile {

/// Markers of a garment, one per material, as JSON: `use`, `length` and `rounds` of all together,
/// then of each what it says, with the place of every copy (docs/marker.md).
/// @param minutesPerMetre  of seam, where a person has said it
/// Cost: linear. Pure.
std::string writeMarkers(const Pattern& pattern, const std::vector<ClothMarker>& markers,
                         const MarkerSettings& settings, std::optional<double> minutesPerMetre);

}  // namespace toile
