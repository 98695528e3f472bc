// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/nest/exact_overlap.h"
#include "core/nest/nest.h"

// For the sources of this folder, of core/marker and core/reading.
namespace toile::nest {

constexpr double kMostSize = 1e7;  ///< mm: of coordinates, so that Clipper's grid holds them

Error wrongItem(const NestItem& item, const Wording& what);

/// Wound, without points that repeat the one before. The square of the points.
/// Errors: MalformedFile naming the subject whose rings are not usable.
Result<Rings> usableRings(const Subject& subject, const Rings& rings);
/// Those of an item. Errors: also where copies, angles, lattice or fixed place are not usable.
Result<Rings> usableRings(const NestItem& item);

/// Such rings farther out by `distance`, holes smaller: at least so far, as arcs are drawn outside.
/// Errors: MalformedFile naming the subject where nothing is left.
Result<Rings> grownRings(const Subject& subject, const Rings& rings, double distance);

}  // namespace toile::nest
