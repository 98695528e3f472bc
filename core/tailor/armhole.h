// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tailor/top_seams.h"

// For the sources of this folder only.
namespace toile::tailor {

/// Finds the armhole of a side whose other lines are known. Where cuts or lines of the mesh lead
/// it, its armpit and shoulder point move there. It stays empty where there is no way.
void findArmhole(const BodyWays& ways, const SeamPull& pull, int side, TopSide& top);

}  // namespace toile::tailor
