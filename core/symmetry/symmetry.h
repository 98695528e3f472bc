// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
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
    /// Pieces with a seam that differs too much from its mirror image, each pair once.
    std::vector<UnequalPieces> unequal{};
    /// Per piece: it keeps its own outline (`withinTolerance`); empty: none does.
    std::vector<bool> kept{};
};

/// The plane and all seams differ by at most the tolerance of `mirrorTolerance`.
bool isWithinTolerance(const Symmetry& symmetry);

/// The same symmetry for drawing only those pieces as mirror images that nearly are: pieces listed
/// in `unequal`, and those with segments that mirror nothing, keep their outlines, and seams
/// between such pieces keep their 3D lengths. Seams shared with a mirrored piece get the common
/// length; the two differ by less than the tolerance.  Cost: linear. Pure.
Symmetry withinTolerance(const Garment& garment, Symmetry symmetry);

/// What mirrors what in a plane. It follows from the pieces and the places of the seams; ease that
/// is stated does not count.
/// @param plane     of the garment as divided
/// @param progress  polled; cancelled, what is returned is worth nothing
/// Precondition: finite positions. Deterministic.  Cost: that of `pairPieces`.  Pure.
Symmetry symmetryIn(const MirrorPlane& plane, const Garment& garment,
                    const Progress& progress = {});

/// The same in the mirror plane of the garment; none where it has none, or after a cancel.
/// Cost: that of `findMirrorPlane`, on the garment as divided.  Pure.
std::optional<Symmetry> findSymmetry(const Garment& garment, const Progress& progress = {});

}  // namespace toile
