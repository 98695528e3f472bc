// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_links.h"

namespace toile {

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
