// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/marker/marker_settings.h"

namespace toile {

/// Settings and manual placements for the pieces of one material.
struct MarkerPlan {
    MarkerSettings settings{};
    std::vector<KeptCopy> kept{};  ///< by copy, each once; includes pieces that no longer exist

    bool operator==(const MarkerPlan&) const = default;
};

/// By material; the garment's own fabric has an empty name.
using MarkerPlans = std::map<std::string, MarkerPlan>;

}  // namespace toile
