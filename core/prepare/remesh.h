// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Remeshes a surface to nearly equilateral triangles, after [BK04] section 4: splits long edges,
/// collapses short ones, equalises valences by flips, moves vertices within the surface, and
/// repeats. Rims keep their lengths to 0.3 %, and their corners, except some closer than half an
/// edge length to the next (`findRimCorners`); edges along crooked rims may be shorter than wanted.
/// Vertices stay within a fraction of the edge length of the input; they leave it only to balance
/// the chords on both sides.
/// @param mesh        mm, an oriented manifold (`isValidSurface`)
/// @param edgeLength  mm, > 0
/// @return nothing if cancelled, if the input is not a valid surface, if the result would have
///         millions of triangles, or if more than 4000 edges of the input meet in a vertex. Else an
///         oriented manifold of the same topology; it is a valid surface unless needles of the
///         input remain: see `repair`
/// Cost: n log n, a quarter of a second for 60 000 triangles. Same input, same output. Pure.
std::optional<MeshArrays> remeshed(const MeshArrays& mesh, double edgeLength,
                                   const Progress& progress);

/// The vertices that a rim keeps if it gets edges of another length: its corners, and others about
/// an edge length apart. The polygon through them is up to 0.3 % shorter than the rim. Vertices in
/// between may be removed or slide along the rim, within that bound.
/// @param edgeLength  mm, > 0
/// @return in order along the rim; at least its first vertex
/// Cost: n log n. Pure.
std::vector<int> findRimCorners(const Points3& V, const RimLoop& rim, double edgeLength);

}  // namespace toile
