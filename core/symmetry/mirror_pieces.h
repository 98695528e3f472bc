// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// Pairs of pieces that are mirror images.
struct MirrorPieces {
    /// Per piece: its mirror image, itself if it is symmetric, or -1.
    std::vector<int> counterpart;
    /// Per piece: root mean square distance, over the area, between the reflected piece and its
    /// counterpart, in both directions, mm; the same for both. 0 without a counterpart.
    std::vector<double> deviation;
};

/// A piece's counterpart is the piece that most of its area is nearest to after reflection, if the
/// reverse holds too.
/// Precondition: finite positions. Deterministic.
/// @param progress  polled for each vertex; after a cancel the result is empty
/// Cost: O(log #F) for each of at most 20 000 vertices, twice.  Pure.
MirrorPieces pairPieces(const Garment& garment, const MirrorPlane& plane,
                        const Progress& progress = {});

}  // namespace toile
