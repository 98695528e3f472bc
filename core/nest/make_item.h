// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nest/problem.h"

// For the sources of this folder only.
namespace toile::nest {

/// The variants of an item that fit the strip; takes time for their circles.
/// @param bare, grown  its rings, and by half the gap
/// @param isBareToo  they are looked at without the gap, too
/// Errors: PageTooSmall naming an item that fits at none of its angles.
Result<Item> makeItem(const Problem& problem, const NestItem& asked, Rings bare, Rings grown,
                      bool isBareToo);

}  // namespace toile::nest
