// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/symmetry.h"

#include <algorithm>
#include <utility>

namespace toile {

Symmetry symmetryIn(const MirrorPlane& plane, const Garment& garment, const Progress& progress) {
    MirrorPieces pieces = pairPieces(garment, plane, progress);
    MirrorSegments segments = seamSegments(garment);
    SegmentPairs pairs = pairSegments(segments, pieces.counterpart, plane);
    CommonLengths lengths = commonLengths(garment, segments, pieces.counterpart, pairs);
    auto unequal = unequalPieces(garment, segments, pieces.counterpart, lengths);
    return {plane,
            std::move(pieces),
            std::move(segments),
            std::move(pairs),
            std::move(lengths),
            std::move(unequal)};
}

bool isWithinTolerance(const Symmetry& symmetry) {
    return symmetry.unequal.empty() && symmetry.plane.deviation <= mirrorTolerance(0, 0);
}

Symmetry withinTolerance(const Garment& garment, Symmetry symmetry) {
    const std::vector<int>& counterpart = symmetry.pieces.counterpart;
    symmetry.kept.assign(counterpart.size(), false);
    for (std::size_t p = 0; p < counterpart.size(); ++p) {
        const int other = counterpart[p];
        if (other < 0 || std::ranges::count(symmetry.pairs[p], -1) > 0) {
            symmetry.kept[p] = symmetry.kept[other < 0 ? p : other] = true;
        }
    }
    for (const UnequalPieces& one : symmetry.unequal) {
        symmetry.kept[one.piece] = symmetry.kept[one.counterpart] = true;
    }
    const auto isKept = [&symmetry](const SeamSide& side) {
        return side.piece < 0 || symmetry.kept[side.piece];
    };
    const std::vector<Seam>& seams = garment.seams.seams;
    CommonLengths& lengths = symmetry.lengths;
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const int image = lengths.mirrored[s];
        if (image >= 0 && isKept(seams[s].left) && isKept(seams[s].right)) {
            lengths.factor[s] = lengths.factor[image] = 1;
        }
    }
    return symmetry;
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
