// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/tailor/seam_pull.h"

namespace toile::tailor {

/// The line in the mirror plane from one rim to another, in the front or in the back: where the
/// mesh has the likelier one, else in the back.
std::vector<int> centreLine(const BodyWays& ways, const SeamPull& pull,
                            const std::vector<int>& from, const std::vector<int>& to);

/// The line around the narrowest height of a trunk, from one side line to the other through the
/// front and back again; empty where the trunk is nearly as narrow everywhere, or where a person
/// has cut around it.
/// @param sides  from below the arms to the hem
std::vector<int> waistLine(const BodyWays& ways, const SeamPull& pull,
                           const std::array<std::vector<int>, 2>& sides);

}  // namespace toile::tailor
