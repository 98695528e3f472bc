// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// How much farther it is from holes to the outline than it can be in the plane, if all rims keep
/// their lengths: 0.3, and cloth that is laid flat as such a ring must stretch by 30 % across, on
/// average, to be worn. 0 or less of cloth that may lie flat as it is; infinite where the hole has
/// no place inside of the outline.
///
/// In whatever direction one looks, the outermost point of a flat hole has the cloth's edge so far
/// beyond it as it is from there to the outline. So the outline is longer than the hull of the hole
/// by 2 pi times that distance at least, as the mean of all directions (Cauchy). The hole's hull is
/// measured as the hole lies, in the direction in which it is open.
/// @param holes    rims of the surface, as is the outline
/// @param ignored  what is no more than this may be overstated
/// Cost: per hole O(n log n), and where it is more than `ignored` some straightenings. Pure.
std::vector<double> strainsAcross(const SurfaceLinks& links, const RimLoop& outline,
                                  const std::vector<RimLoop>& holes, double ignored);

}  // namespace toile
