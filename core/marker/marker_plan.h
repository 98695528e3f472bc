// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/marker/marker_settings.h"

namespace toile {

/// What a person has said of laying the pieces of one material.
struct MarkerPlan {
    MarkerSettings settings{};
    std::vector<KeptCopy> kept{};  ///< by copy, each once; of pieces that are no more there, too

    bool operator==(const MarkerPlan&) const = default;
};

/// By material; the garment's own fabric has no name.
using MarkerPlans = std::map<std::string, MarkerPlan>;

}  // namespace toile
