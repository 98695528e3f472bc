// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_links.h"

namespace toile {

/// The shortest way around a tube, from a place and back to it: around the leg of trousers, the
/// sleeve of a shirt, through a handle. Of the closed ways that cannot be drawn together to a point
/// it is the shortest along edges, pulled tight (see straightened) with the place held. Holes in
/// the cloth (`sortLoops`) are nothing to go around.
/// @return  first and last point are the place
/// @param progress  polled while ways are looked for
/// @errors  a cut error where nothing is there to go around; Cancelled
/// Precondition: connected, manifold, oriented. Cost: O(#E log #E). Deterministic. Re-entrant.
Result<PathPolyline> loopAround(const SurfaceLinks& links, const SurfacePoint& place,
                                const Progress& progress = Progress());

/// Places along a closed line, its first point first, equally far from each other: from one to the
/// next the shortest way runs as the line does.
std::vector<Eigen::Vector3d> placesAlong(const MeshArrays& mesh, const PathPolyline& loop,
                                         int count);

}  // namespace toile
