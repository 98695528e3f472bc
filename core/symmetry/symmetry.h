// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/garment.h"
#include "core/symmetry/common_lengths.h"
#include "core/symmetry/mirror_pieces.h"
#include "core/symmetry/mirror_plane.h"
#include "core/symmetry/mirror_segments.h"

namespace toile {

/// A garment as its own mirror image.
struct Symmetry {
    MirrorPlane plane;
    MirrorPieces pieces;
    MirrorSegments segments;
    SegmentPairs pairs;     ///< of `segments`
    CommonLengths lengths;  ///< of the seams
};

/// None where the garment has no mirror plane. It follows from the pieces and the places of the
/// seams; ease that is stated does not count.
/// Precondition: finite positions. Deterministic.  Cost: that of `findMirrorPlane`.  Pure.
std::optional<Symmetry> findSymmetry(const Garment& garment);

}  // namespace toile
