// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/garment/garment.h"
#include "core/symmetry/mirror_plane.h"

namespace toile {

/// A stretch of outline between two turn points.
struct MirrorSegment {
    int piece = -1;
    int neighbour = -1;  ///< the piece sewn there: -1 if free, the same piece for a dart
    double length = 0;   ///< on the garment, mm
    Eigen::Vector3d middle{0, 0, 0};  ///< on the garment, mm
    int seam = -1;                    ///< the seam of the graph that it is a side of; -1: not known
    bool isRight = false;             ///< whether it is the seam's right side
};

/// The side of a known seam that a segment runs along.
inline const SeamSide& sideOf(const Garment& garment, const MirrorSegment& segment) {
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(segment.seam)];
    return segment.isRight ? seam.right : seam.left;
}

/// Per piece, in order along its outline.
using MirrorSegments = std::vector<std::vector<MirrorSegment>>;
/// Per piece and segment: the segment of its counterpart that mirrors it, or -1. For a piece that
/// is symmetric these are its own segments; one across the mirror line maps to itself.
using SegmentPairs = std::vector<std::vector<int>>;

/// Sides of seams and free edges on the outlines as segments. The right sides of stacked seams are
/// left out: their places belong to other seams.
/// Cost: linear in the outlines' edges for each seam side.  Pure.
MirrorSegments seamSegments(const Garment& garment);

/// Largest difference between the lengths of two paired segments, as a fraction of the longer: if
/// the order of the segments identifies the pair, and if it does not.
inline constexpr double kMaxDifferenceInOrder = 0.25, kMaxDifferenceAlone = 0.05;

/// Pairs segments by their order: the outlines of mirrored pieces run in opposite directions. Of
/// the rotations for which all neighbours are each other's counterparts, chooses the one with the
/// closest middles after reflection. Without such a rotation, pairs only segments whose neighbour
/// occurs once on either outline. Positions alone would give wrong pairs, because draped cloth is
/// not symmetric. Neighbours without counterparts count as matching. Segments of too different
/// lengths stay unpaired.
/// @param counterpart  per piece (`MirrorPieces`); mutual
/// Cost: quadratic in the segments of a piece.  Pure.
SegmentPairs pairSegments(const MirrorSegments& segments, const std::vector<int>& counterpart,
                          const MirrorPlane& plane);

/// Index of a segment in `MirrorSegments`.
struct SegmentPlace {
    int piece = -1, segment = -1;

    bool operator==(const SegmentPlace&) const = default;
};

/// Segments without a counterpart, by piece and order.  Cost: linear. Pure.
std::vector<SegmentPlace> unpairedSegments(const SegmentPairs& pairs);

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
