// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_paths.h"

namespace toile {

/// Closes holes for the solve: the mesh's own vertices and faces first, then one new vertex per
/// hole and the fan of triangles around it (a hole of three edges takes one triangle and no
/// vertex); remove the added faces to restore the holes. Caps need not be flat: if a fan from the
/// hole's centre would have a flat triangle, as in a closed buttonhole, it is raised to a cone.
/// Cost: linear. Pure.
MeshArrays fillHoles(const MeshArrays& mesh, const std::vector<RimLoop>& holes);

/// A loop shorter than this fraction of the piece's longest loop is a hole in the cloth.
inline constexpr double kSmallHole = 0.05;

/// The loops of a piece, divided into those that a seam must join and those that may stay.
struct SortedLoops {
    std::vector<RimLoop> openings;  ///< ends of a tube; the outline is always one
    std::vector<RimLoop> holes;     ///< a buttonhole, the neck of a poncho
};

/// A loop is a hole in the cloth, which lies flat without any cut, if it is short, or if the piece
/// is flat: then the longest loop turns by one full turn and the hole by minus one, while the ends
/// of a tube do not turn (Gauss-Bonnet). Three quarters of a turn are enough for both, because a
/// folded hem turns like a hole, too; and the ring must fit in the plane (`strainsAcross`).
/// @param smallHole  fraction of the longest loop below which a loop is short; 0: no holes at all
/// Precondition: manifold and oriented. Linear, but n log n with long holes.
SortedLoops sortLoops(const SurfaceLinks& links, double smallHole = kSmallHole);

}  // namespace toile
