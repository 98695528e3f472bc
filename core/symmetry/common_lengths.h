// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/symmetry/mirror_segments.h"

namespace toile {

/// Common lengths of mirrored seams.
struct CommonLengths {
    /// Per seam of the graph: scale factor for the edges of both its sides; 1 if it has no
    /// counterpart, or mirrors itself.
    std::vector<double> factor;
    /// Per seam: its mirror image, itself if it lies across the plane; -1 if it has none. Mutual.
    std::vector<int> mirrored;

    /// Seams and free edges without a mirror image, ascending.  Cost: linear.
    std::vector<int> withoutCounterpart() const;
};

/// Two seams mirror each other if a side of one is paired with a side of the other, and no side of
/// either with a third seam. Their common length is the mean of their lengths; the length of a seam
/// is the mean of its two sides. Both sides of a seam are scaled by the same factor, so that equal
/// sides stay equal and eased sides keep their ratio. If each seam has equal sides, all four are
/// equal afterwards, up to rounding. A stacked seam's factor does not apply to its right side,
/// which belongs to another seam.
/// @param segments     `seamSegments` of the garment
/// @param counterpart  per piece (`MirrorPieces`)
/// @param pairs        how the segments are paired (`pairSegments`)
/// Cost: linear.  Pure.
CommonLengths commonLengths(const Garment& garment, const MirrorSegments& segments,
                            const std::vector<int>& counterpart, const SegmentPairs& pairs);

/// Largest difference between the lengths of two mirrored seams, mm, for their pieces to be
/// mirrored automatically: 2 mm, or 1 % of the longer one.
double mirrorTolerance(double length, double mirroredLength);

/// Two mirrored pieces, or one that is symmetric, and the seam that differs most from its mirror
/// image, relative to the tolerance.
struct UnequalPieces {
    int piece = -1, counterpart = -1;  ///< the longer seam is of `piece`
    int seam = -1, mirrored = -1;
    double difference = 0;  ///< of the two seams' lengths, mm; positive
    double tolerance = 0;   ///< mm
};

/// The mirrored pieces whose seams differ by more than the tolerance, each pair once, by piece.
/// @param segments, counterpart  as for `commonLengths`  Cost: linear. Pure.
std::vector<UnequalPieces> unequalPieces(const Garment& garment, const MirrorSegments& segments,
                                         const std::vector<int>& counterpart,
                                         const CommonLengths& lengths);

/// Largest difference between a seam's common length and its own, over both sides of all seams, mm.
/// @param lengths  of these seams  Cost: linear. Pure.
double largestChange(const SeamGraph& seams, const CommonLengths& lengths);

}  // namespace toile
