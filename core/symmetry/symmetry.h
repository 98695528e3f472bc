// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/symmetry/mirror_plane.h"
#include "core/symmetry/mirror_segments.h"
#include "core/symmetry/mirrored_pair.h"

namespace toile {

/// Mirror symmetry of a garment.
struct Symmetry {
    MirrorPlane plane;
    MirrorPieces pieces;
    MirrorSegments segments;
    SegmentPairs pairs;     ///< of `segments`
    CommonLengths lengths;  ///< of the seams
    /// Pieces with a seam that differs too much from its mirror image, each pair once.
    std::vector<UnequalPieces> unequal{};
    /// Per piece: it keeps its own outline (`withinTolerance`); empty: no piece does.
    std::vector<bool> kept{};
};

/// Whether the plane's deviation and all seam differences are within `mirrorTolerance`.
bool isWithinTolerance(const Symmetry& symmetry);

/// The same symmetry, restricted to pieces that nearly are mirror images: pieces listed in
/// `unequal`, and those with unpaired segments, keep their outlines, and seams between such pieces
/// keep their 3D lengths. Seams shared with a mirrored piece get the common length; the two differ
/// by less than the tolerance.  Cost: linear. Pure.
Symmetry withinTolerance(const Garment& garment, Symmetry symmetry);

/// Finds mirrored pieces, segments and seams for a plane. Depends on the pieces and the places of
/// the seams; stated ease is ignored.
/// @param plane     of the garment as divided
/// @param progress  polled; after a cancel the result is invalid
/// Precondition: finite positions. Deterministic.  Cost: that of `pairPieces`.  Pure.
Symmetry symmetryIn(const MirrorPlane& plane, const Garment& garment,
                    const Progress& progress = {});

/// The same in the mirror plane of the garment; nothing without a plane, or after a cancel.
/// Cost: that of `findMirrorPlane`, on the garment as divided.  Pure.
std::optional<Symmetry> findSymmetry(const Garment& garment, const Progress& progress = {});

}  // namespace toile
