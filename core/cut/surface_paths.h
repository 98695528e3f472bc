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

/// The shortest path along edges from one vertex to another. Ties are decided by index, so that the
/// same mesh gives the same path. If both vertices are equal it has no length.
/// @param progress  polled during the search, nothing is reported
/// @errors  a cut error if the vertices are not connected; Cancelled
/// Cost: linear, plus O(n log n) in the edges closer to `from` than the path is long. Re-entrant.
Result<PathPolyline> edgePath(const SurfaceLinks& links, int from, int to,
                              const Progress& progress = Progress());

/// A path of vertices as surface points. Precondition: neighbours share an edge.
PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices);

/// Positions in space of a path's points. Cost: linear. Pure.
std::vector<Eigen::Vector3d> positionsOf(const MeshArrays& mesh, const PathPolyline& path);

/// Short paths across the surface, through the insides of triangles: A* on a graph of vertices and
/// points on edges (after [Lan99]) decides on which side to pass each bump, then the path is pulled
/// tight (see straightened). Locally shortest, and never longer than the path along edges; probably
/// the shortest, but not guaranteed. May run along a rim.
/// @return  points from `from` to `to`; a single one twice if both are equal
/// @param progress  polled while the graph is searched, nothing is reported
/// @errors  a cut error if the points are not connected; Cancelled
/// Cost: O(n log n) in the triangles closer to `from` than the path is long. Re-entrant.
Result<PathPolyline> geodesicPath(const SurfaceLinks& links, const SurfacePoint& from,
                                  const SurfacePoint& to, const Progress& progress = Progress());

}  // namespace toile
