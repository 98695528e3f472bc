// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// Ways along edges that open a connected, manifold, oriented mesh to one disk. Weights, one per
/// edge, say what is short; ties are decided by index. Each way is a list of vertices.
using EdgeWays = std::vector<std::vector<int>>;

/// For a mesh with a rim: arcs from rim to rim, one less than there are loops plus two for every
/// handle. The shortest such arcs one after the other, by a tree of shortest paths from the rim and
/// the dearest tree of faces that does not cross it ([EW05], the rim as base point). For a piece
/// without handles they are the minimum spanning tree of its loops. Shortest first.
/// Cost: O(#E log #E).
EdgeWays arcsBetweenRims(const SurfaceLinks& links, const std::vector<double>& weights);

/// For a closed mesh with handles: a graph of loops through a point, of a few points tried the one
/// with the shortest, cut into ways between its branchings. Cost: a few times the above.
EdgeWays loopsAroundHandles(const SurfaceLinks& links, const std::vector<double>& weights);

/// For a closed mesh without handles: a short tree through its sharpest points (most angle missing
/// around the vertex), or between its two ends where nothing is sharp, cut into ways between
/// branchings and ends ([Meh88]). Cost: O(#E log #E).
EdgeWays treeThroughPeaks(const SurfaceLinks& links, const std::vector<double>& weights);

}  // namespace toile
