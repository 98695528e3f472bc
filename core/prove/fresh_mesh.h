// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::prove {

/// Triangles of a flat shape.
struct FreshMesh {
    Points2 Q;    ///< mm: the points of the loops, loop by loop, then those inside
    Triangles F;  ///< anti-clockwise; sorted, each from its smallest vertex
    /// Per inside point: index of the given point; empty for points of a grid.
    std::vector<int> insideOf{};
};

/// Fills an outline with even triangles: constrained Delaunay, with inside points on a grid of
/// equilateral triangles, moved to the mean of their neighbours, or with given points, which do not
/// move. No points are added to the outline. The two coincident sides of a slit stay separate.
/// @param loops    the outline, anti-clockwise, then the holes, clockwise; closed, at least 3
///                 points each, the first not repeated
/// @param edge     mm, of the grid; points nearer to the outline than a part of it are left out
/// @param subject  owner of the outline, for errors
/// @param inside   points to use instead of a grid, or null; `insideOf` lists those used
/// Errors: OutlineCrosses.  Cost: n log n, and inner times boundary points. Pure.
Result<FreshMesh> freshMesh(const std::vector<Points2>& loops, double edge, const Subject& subject,
                            const Points2* inside = nullptr);

}  // namespace toile::prove
