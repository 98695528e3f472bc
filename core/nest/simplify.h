// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/exact_overlap.h"

// For the sources of this folder only.
namespace toile::nest {

/// Simplifies rings to fewer points that enclose the same area, extended by at most `tolerance` mm:
/// cuts off concave corners, and removes sides whose neighbours meet beyond them, smallest added
/// area first, until `enough` points are left. Skips changes that make a ring touch itself.
/// Precondition: oriented. Cost: quadratic in the points.
Rings simplified(const Rings& rings, double tolerance, std::size_t enough);

}  // namespace toile::nest
