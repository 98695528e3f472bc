// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/nest/collision.h"
#include "core/nest/nest.h"

// For the sources of this folder, of core/marker and core/formats.
namespace toile::nest {

constexpr double kMaxSize = 1e7;  ///< mm: largest coordinate, so that Clipper's grid can hold it

Error wrongItem(const NestItem& item, const Wording& what);

/// Oriented, without points that repeat their predecessor. Cost: quadratic in the points.
/// Errors: MalformedFile naming the subject whose rings are unusable.
Result<Rings> usableRings(const Subject& subject, const Rings& rings);
/// The rings of an item. Errors: also if copies, angles, lattice or fixed place are unusable.
Result<Rings> usableRings(const NestItem& item);

/// Offsets rings outwards by `distance`, holes shrink: at least so far, as arcs are drawn outside.
/// Errors: MalformedFile naming the subject if no area is left.
Result<Rings> grownRings(const Subject& subject, const Rings& rings, double distance);

}  // namespace toile::nest

// For the sources of this folder only.
namespace toile::nest {

/// Simplifies rings to fewer points that enclose the same area, extended by at most `tolerance` mm:
/// cuts off concave corners, and removes sides whose neighbours meet beyond them, smallest added
/// area first, until `enough` points are left. Skips changes that make a ring touch itself.
/// Precondition: oriented. Cost: quadratic in the points.
Rings simplified(const Rings& rings, double tolerance, std::size_t enough);

}  // namespace toile::nest
