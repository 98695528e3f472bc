// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// Closes holes for the solve: the mesh's own vertices and faces first, then one new vertex per
/// hole and the fan of triangles around it (a hole of three edges takes one triangle and no
/// vertex); take the further faces out again to have the holes back. Caps need not lie flat: where
/// a fan from the hole's middle would have a flat triangle, as in a buttonhole that is shut, it is
/// raised to a cone. Cost: linear. Pure.
MeshArrays fillHoles(const MeshArrays& mesh, const std::vector<RimLoop>& holes);

/// A loop shorter than this fraction of the piece's longest loop is a hole in the cloth.
inline constexpr double kSmallHole = 0.05;

/// The loops of a piece, divided into those that a seam must join and those that may stay.
struct SortedLoops {
    std::vector<RimLoop> openings;  ///< ends of a tube; the outline is always one
    std::vector<RimLoop> holes;     ///< a buttonhole, the neck of a poncho
};

/// A loop is a hole in the cloth, which lies flat without any cut, where it is short, or where the
/// piece is flat: then the longest loop turns by one full turn and the hole by minus one, while the
/// ends of a tube turn by none (Gauss-Bonnet): three quarters of a turn are enough of both, as a
/// folded hem turns like a hole, too; and the ring must have room in the plane (`strainsAcross`).
/// @param smallHole  fraction of the longest loop below which a loop is short; 0: no hole at all
/// Precondition: manifold and oriented. Linear but for long holes: n log n with these.
SortedLoops sortLoops(const SurfaceLinks& links, double smallHole = kSmallHole);

}  // namespace toile
