// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/fill_holes.h"
#include "core/cut/surface_paths.h"

namespace toile {

/// Pulls a curve tight on the surface with its ends fixed: takes the shortest path through the
/// unfolded strip of triangles, then leads the strip around the other side of every vertex where
/// that is shorter, until no such vertex is left ([XW07], the same idea). The result is locally
/// shortest: it turns only at rims, and at vertices with more than a full turn around them. It can
/// be deformed into the given curve, so that a loop around a handle stays one; it is never longer.
/// If neighbouring points share no triangle, the curve is returned unchanged.
/// Cost: a few passes over the strip.
PathPolyline straightened(const SurfaceLinks& links, const PathPolyline& path);

/// Pulls a cut tight, and slides an end at a vertex of a rim along its loop from vertex to vertex
/// as long as that shortens the cut. Cost: some dozens of straightenings.
PathPolyline shortenedCut(const SurfaceLinks& links, const std::vector<RimLoop>& rims,
                          const PathPolyline& cut);

}  // namespace toile
