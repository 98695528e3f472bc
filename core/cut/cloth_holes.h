// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/fill_holes.h"

namespace toile {

/// A loop shorter than this fraction of the piece's longest loop is a hole in the cloth.
inline constexpr double kSmallHole = 0.05;

/// The loops of a piece, divided into those that a seam must join and those that may stay.
struct SortedLoops {
    std::vector<RimLoop> openings;  ///< ends of a tube; the outline is always one
    std::vector<RimLoop> holes;     ///< a buttonhole, the neck of a poncho
};

/// A loop is a hole in the cloth, which lies flat without any cut, where it is short, or where the
/// piece is flat: then the longest loop turns by one full turn and the hole by minus one, while the
/// ends of a tube turn by none (Gauss-Bonnet). Three quarters of a turn are enough. Both are asked
/// for, since the rim of a hem folded inwards turns like a hole too.
/// @param smallHole  fraction of the longest loop below which a loop is short; 0: no hole at all
/// Precondition: manifold and oriented. Linear.
SortedLoops sortLoops(const SurfaceLinks& links, double smallHole = kSmallHole);

}  // namespace toile
