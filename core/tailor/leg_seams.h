// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/tailor/seam_pull.h"

namespace toile::tailor {

/// The lines of trousers; each a way of vertices, of legs first the one with `across` below 0.
struct LegSeams {
    std::vector<int> centre;  ///< from the front of the waist between the legs to its back
    std::array<std::vector<int>, 2> inseam;  ///< from the crotch, a vertex of `centre`, to an ankle
    std::array<std::vector<int>, 2> side;    ///< from the waist to an ankle
};

std::optional<LegSeams> legSeams(const BodyWays& ways, const SeamPull& pull);

/// The two lines of a skirt from the waist to the hem, where it is widest.
std::array<std::vector<int>, 2> skirtSides(const BodyWays& ways, const SeamPull& pull);

}  // namespace toile::tailor
