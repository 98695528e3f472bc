// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_links.h"
#include "core/geometry/shortest_paths.h"

namespace toile {

/// Lengths of all edges.
std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges);

/// The shortest path along edges, from one vertex to another. Equal ways are decided by index, so
/// that the same mesh gives the same way. Where the two vertices are one it has no length.
/// @param progress  polled while the way is looked for, nothing is reported
/// @errors  a cut error where the vertices are not connected; Cancelled
/// Cost: linear, and O(n log n) in the edges nearer to `from` than the way is long. Re-entrant.
Result<PathPolyline> edgePath(const SurfaceLinks& links, int from, int to,
                              const Progress& progress = Progress());

/// A way of vertices as surface points. Precondition: neighbours share an edge.
PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices);

/// Where a path's points lie in space. Cost: linear. Pure.
std::vector<Eigen::Vector3d> positionsOf(const MeshArrays& mesh, const PathPolyline& path);

/// Short ways across the surface, through the insides of triangles: A* on a graph of vertices and
/// points on edges (after [Lan99]) finds the side of every bump to pass on, then the way is pulled
/// tight (see straightened). Locally shortest, and never longer than the way along edges; that no
/// other way is shorter is likely, not promised. May run along a rim.
/// @return  points from `from` to `to`; a single one twice where both are the same
/// @param progress  polled while the graph is searched, nothing is reported
/// @errors  a cut error where the points are not connected; Cancelled
/// Cost: O(n log n) in the triangles nearer to `from` than the way is long. Re-entrant.
Result<PathPolyline> geodesicPath(const SurfaceLinks& links, const SurfacePoint& from,
                                  const SurfacePoint& to, const Progress& progress = Progress());

}  // namespace toile
