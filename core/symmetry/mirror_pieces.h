// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// Which piece is the mirror image of which.
struct MirrorPieces {
    /// Per piece: the one that mirrors it, itself where it is symmetric in itself, or -1.
    std::vector<int> counterpart;
    /// Per piece: root mean square distance, over the area, between the piece reflected and its
    /// counterpart, and the other way round, mm; the same for both. 0 where there is none.
    std::vector<double> deviation;
};

/// A piece's counterpart is the one that most of its area is nearest to once it is reflected, if
/// that holds the other way round too.
/// Precondition: finite positions. Deterministic.
/// @param progress  polled from vertex to vertex; cancelled, there are none
/// Cost: O(log #F) for each of at most 20 000 vertices, twice.  Pure.
MirrorPieces pairPieces(const Garment& garment, const MirrorPlane& plane,
                        const Progress& progress = {});

}  // namespace toile
