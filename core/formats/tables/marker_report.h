// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/marker/cloth_marker.h"

namespace toile {

/// A marker and its input.
struct MadeMarker {
    std::shared_ptr<const Pattern> pattern;  ///< not null
    MarkerSettings settings;
    ClothMarker marker;
};

/// Markers of a garment, one per material, as JSON: `use`, `length` and `rounds` of all together,
/// then the figures of each, with the place of every copy (docs/marker.md).
/// @param minutesPerMetre  of seam, if the user has set it
/// Cost: linear. Pure. Precondition: there is at least one marker.
std::string writeMarkers(const std::vector<MadeMarker>& markers,
                         std::optional<double> minutesPerMetre);

}  // namespace toile
