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
    Triangles F;  ///< anti-clockwise; sorted, each from its least vertex on
    /// Of those inside which of the given points each is; none where they are a grid's.
    std::vector<int> insideOf{};
};

/// Fills an outline with even triangles: constrained Delaunay, with points inside on a grid of
/// equal triangles, moved to the middle of their neighbours, or on given ones as they are. On the
/// outline none are added.
/// The two sides of a slit stay two, although they lie on each other.
/// @param loops    the outline, anti-clockwise, then the holes, clockwise; closed, at least 3
///                 points each, the first not repeated
/// @param edge     mm, of the grid; points nearer to the outline than a part of it are left out
/// @param subject  whose outline it is
/// @param inside   points to take in place of a grid, or null; `insideOf` says which were
/// Errors: OutlineCrosses.  Cost: n log n, and inner times boundary points. Pure.
Result<FreshMesh> freshMesh(const std::vector<Points2>& loops, double edge, const Subject& subject,
                            const Points2* inside = nullptr);

}  // namespace toile::prove
