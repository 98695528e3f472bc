// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/symmetry/mirror_segments.h"

namespace toile {

/// Lengths that mirrored seams have in common.
struct CommonLengths {
    /// Per seam of the graph: by what the edges of both its sides are to be scaled; 1 where it has
    /// no counterpart, or mirrors itself.
    std::vector<double> factor;
    /// Per seam: the one that is its mirror image, itself if it lies across the plane; -1 where
    /// there is none. Mutual.
    std::vector<int> mirrored;

    /// Seams and free edges that have no mirror image, ascending.  Cost: linear.
    std::vector<int> withoutCounterpart() const;
};

/// Two seams mirror each other where a side of one is paired with a side of the other, and no side
/// of either with a third seam. Their common length is the mean of theirs, and the length of a seam
/// the mean of its two sides'. Both sides of a seam are scaled alike: what is equal stays equal,
/// and what is to be eased in keeps its ratio. Where each of the two has equal sides all four are
/// equal afterwards, to rounding. A stacked seam's factor does not hold on its right side, which is
/// another seam's place.
/// @param segments     `seamSegments` of the garment
/// @param counterpart  per piece (`MirrorPieces`)
/// @param pairs        how the segments are paired (`pairSegments`)
/// Cost: linear.  Pure.
CommonLengths commonLengths(const Garment& garment, const MirrorSegments& segments,
                            const std::vector<int>& counterpart, const SegmentPairs& pairs);

/// By how much the lengths of two mirrored seams may differ for their pieces to be mirrored
/// unasked, mm: 2 mm, or 1 % of the longer one.
double mirrorTolerance(double length, double mirroredLength);

/// Two mirrored pieces, or one that is symmetric in itself, and the seam that differs most from its
/// mirror image, measured in tolerances.
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

/// By how much a seam's common length differs from its own, at most, over both sides of all, mm.
/// @param lengths  of these seams  Cost: linear. Pure.
double largestChange(const SeamGraph& seams, const CommonLengths& lengths);

}  // namespace toile
