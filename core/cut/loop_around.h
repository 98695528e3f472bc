// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_paths.h"

namespace toile {

/// How much farther holes are from the outline than is possible in the plane if all rims keep their
/// lengths: 0.3 means that such a ring, laid flat, must stretch by 30 % across, on average, to be
/// worn. 0 or less if the cloth may already be flat; infinite if the hole does not fit inside the
/// outline.
///
/// In any direction, the edge of flat cloth lies as far beyond the outermost point of a hole as the
/// distance from there to the outline. So the outline is longer than the hull of the hole by at
/// least 2 pi times that distance, averaged over all directions (Cauchy). The hole's hull is
/// measured as placed in 3D, along the normal of its opening.
/// @param holes    rims of the surface, as is the outline
/// @param ignored  values up to this may be overestimated
/// Cost: per hole O(n log n), and above `ignored` some straightenings. Pure.
std::vector<double> strainsAcross(const SurfaceLinks& links, const RimLoop& outline,
                                  const std::vector<RimLoop>& holes, double ignored);

/// The shortest loop around a tube through a given point: around a trouser leg, a sleeve, or
/// through a handle. Of the closed curves that cannot be contracted to a point it is the shortest
/// along edges, then pulled tight (see straightened) with the point fixed. Holes in the cloth
/// (`sortLoops`) do not count as obstacles.
/// @return  first and last point are the given point
/// @param progress  polled during the search
/// @errors  a cut error if there is nothing to go around; Cancelled
/// Precondition: connected, manifold, oriented. Cost: O(#E log #E). Deterministic. Re-entrant.
Result<PathPolyline> loopAround(const SurfaceLinks& links, const SurfacePoint& place,
                                const Progress& progress = Progress());

/// Evenly spaced points along a closed line, its first point first, so many that the shortest path
/// between neighbours follows the line.
std::vector<Eigen::Vector3d> placesAlong(const MeshArrays& mesh, const PathPolyline& loop,
                                         int count);

}  // namespace toile
