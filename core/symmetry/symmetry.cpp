// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/symmetry.h"

#include <utility>

namespace toile {

Symmetry symmetryIn(const MirrorPlane& plane, const Garment& garment, const Progress& progress) {
    MirrorPieces pieces = pairPieces(garment, plane, progress);
    MirrorSegments segments = seamSegments(garment);
    SegmentPairs pairs = pairSegments(segments, pieces.counterpart, plane);
    CommonLengths lengths = commonLengths(garment, segments, pieces.counterpart, pairs);
    return {plane, std::move(pieces), std::move(segments), std::move(pairs), std::move(lengths)};
}

std::optional<Symmetry> findSymmetry(const Garment& garment, const Progress& progress) {
    const auto plane = findMirrorPlane(garment.uncut, progress);
    if (!plane) {
        return std::nullopt;
    }
    Symmetry symmetry = symmetryIn(*plane, garment, progress);
    return progress.isCancelled() ? std::nullopt : std::optional(std::move(symmetry));
}

}  // namespace toile
