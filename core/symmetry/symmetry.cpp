// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/symmetry.h"

#include <utility>

namespace toile {

std::optional<Symmetry> findSymmetry(const Garment& garment) {
    const auto plane = findMirrorPlane(garment);
    if (!plane) {
        return std::nullopt;
    }
    MirrorPieces pieces = pairPieces(garment, *plane);
    MirrorSegments segments = seamSegments(garment);
    SegmentPairs pairs = pairSegments(segments, pieces.counterpart, *plane);
    CommonLengths lengths = commonLengths(garment, segments, pieces.counterpart, pairs);
    return Symmetry{*plane, std::move(pieces), std::move(segments), std::move(pairs),
                    std::move(lengths)};
}

}  // namespace toile
