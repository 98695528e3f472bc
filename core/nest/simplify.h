// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/exact_overlap.h"

// For the sources of this folder only.
namespace toile::nest {

/// Rings of fewer points around the same area and at most `tolerance` mm of what is beside it:
/// hollow corners are cut off, and sides left out whose neighbours meet beyond them, for the least
/// area first, until there are `enough` points. What would then touch itself stays as it is.
/// Precondition: wound. Cost: the square of the points.
Rings simplified(const Rings& rings, double tolerance, std::size_t enough);

}  // namespace toile::nest
