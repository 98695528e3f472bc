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
    int neighbour = -1;  ///< the piece sewn there: -1 where free, its own where it is a dart
    double length = 0;   ///< on the garment, mm
    Eigen::Vector3d middle{0, 0, 0};  ///< on the garment, mm
    int seam = -1;         ///< the seam of the graph of which it is a side; -1: not known
    bool isRight = false;  ///< the right side of it
};

/// Where a segment of a known seam runs.
inline const SeamSide& sideOf(const Garment& garment, const MirrorSegment& segment) {
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(segment.seam)];
    return segment.isRight ? seam.right : seam.left;
}

/// Per piece, in order along its outline.
using MirrorSegments = std::vector<std::vector<MirrorSegment>>;
/// Per piece and segment: the segment of its counterpart that mirrors it, or -1. Where a piece is
/// symmetric in itself these are its own, and a segment across the mirror line has itself.
using SegmentPairs = std::vector<std::vector<int>>;

/// The sides of seams and the free edges on the outlines as segments. The right sides of stacked
/// seams are left out: their place is another seam's.
/// Cost: linear in the outlines' edges for each seam side.  Pure.
MirrorSegments seamSegments(const Garment& garment);

/// By how much the lengths of two paired segments may differ, as a part of the longer: where the
/// order of the segments tells that they are a pair, and where it does not.
inline constexpr double kMaxDifferenceInOrder = 0.25, kMaxDifferenceAlone = 0.05;

/// Pairs segments by their order: the outlines of mirrored pieces run in opposite senses. Of the
/// rotations for which all neighbours are each other's counterparts, the one whose middles lie
/// nearest to each other once reflected. Where there is none, only segments whose neighbour occurs
/// once on either outline. Places alone would pair wrong ones, as cloth that hangs is not
/// symmetric. Neighbours that have no counterparts count as agreeing. Segments of too different
/// lengths stay unpaired.
/// @param counterpart  per piece (`MirrorPieces`); mutual
/// Cost: quadratic in the segments of a piece.  Pure.
SegmentPairs pairSegments(const MirrorSegments& segments, const std::vector<int>& counterpart,
                          const MirrorPlane& plane);

/// A segment by its place in `MirrorSegments`.
struct SegmentPlace {
    int piece = -1, segment = -1;

    bool operator==(const SegmentPlace&) const = default;
};

/// Those without a counterpart, by piece and order.  Cost: linear. Pure.
std::vector<SegmentPlace> unpairedSegments(const SegmentPairs& pairs);

}  // namespace toile
