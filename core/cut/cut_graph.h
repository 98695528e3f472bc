// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// Paths along edges that open a connected, manifold, oriented mesh to one disk. Weights, one per
/// edge, define length; ties are decided by index. Each path is a list of vertices.
using EdgeWays = std::vector<std::vector<int>>;

/// For a mesh with a rim: arcs from rim to rim, one less than there are loops plus two for every
/// handle. The shortest such arcs in turn, by a tree of shortest paths from the rim and the most
/// expensive tree of faces that does not cross it ([EW05], the rim as base point). For a piece
/// without handles they are the minimum spanning tree of its loops. Shortest first.
/// Cost: O(#E log #E).
EdgeWays arcsBetweenRims(const SurfaceLinks& links, const std::vector<double>& weights);

/// For a closed mesh with handles: a graph of loops through a point, cut into paths between its
/// branchings. Tries a few points and takes the shortest graph. Cost: a few times the above.
EdgeWays loopsAroundHandles(const SurfaceLinks& links, const std::vector<double>& weights);

/// For a closed mesh without handles: a short tree through its sharpest points (largest missing
/// angle around the vertex), or between its two ends if nothing is sharp, cut into paths between
/// branchings and ends ([Meh88]). Cost: O(#E log #E).
EdgeWays treeThroughPeaks(const SurfaceLinks& links, const std::vector<double>& weights);

}  // namespace toile
