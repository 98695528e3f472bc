// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "core/pattern/segments.h"
#include "core/pattern/trueing.h"

namespace toile {
struct Symmetry;
}  // namespace toile

namespace toile::app {

/// One of the segments of a garment.
struct SegmentAt {
    int piece = -1, segment = -1;

    bool operator==(const SegmentAt&) const = default;
};

/// What the outlines as they are drawn differ in from the exact ones. Lengths in mm.
struct DrawnFacts {
    double farthest = 0;                 ///< of a drawn line from the exact outline
    double exactStrain = 0, strain = 0;  ///< largest of an edge, before and after
    bool drawn = false;                  ///< some piece has a line of its own
};

/// @param results  one per piece, or empty; of other pieces they are left out  Cost: linear. Pure.
DrawnFacts drawnFacts(const Garment& garment, const PieceResults& results);

/// What there is to know of a garment's lines. Angles in radians, lengths in mm.
struct LineFacts : DrawnFacts {
    std::vector<OutlineSegments> segments;  ///< one per piece; empty where not flat
    std::vector<SeamEnd> ends;              ///< the largest kink first
    std::vector<double> kept;               ///< kink of each, of the drawn lines

    const Segment& at(const SegmentAt& one) const {
        return segments[static_cast<std::size_t>(one.piece)]
            .segments[static_cast<std::size_t>(one.segment)];
    }
};

/// Cost: linear in outlines and seams. Pure.
/// @param results  one per piece, or empty; of other pieces they are left out
LineFacts lineFacts(const Garment& garment, const PieceResults& results, const LineSettings& lines);

/// The segment that has most of a marked stretch; that which begins at a marked vertex or holds it.
std::optional<SegmentAt> segmentAt(const Garment& garment, const LineFacts& facts,
                                   const Feature& mark);
/// The segment that has most of a seam's left side.
std::optional<SegmentAt> segmentOfSeam(const LineFacts& facts, const Seam& seam);
/// The segment that is sewn to the middle of one; none where that is free.
std::optional<SegmentAt> partnerOf(const Garment& garment, const LineFacts& facts,
                                   const SegmentAt& one);

/// The segment that has most of the place where the middle of one is mirrored; none where it has no
/// counterpart. @param symmetry  of the garment
std::optional<SegmentAt> mirrorOf(const Garment& garment, const LineFacts& facts,
                                  const Symmetry& symmetry, const SegmentAt& one);

/// The turn point at a vertex of a piece's outline; null where there is none.
/// @param at  index into Piece::boundary
const TurnPoint* turnPointOf(const Piece& piece, const OutlineSegments& segments, int at);

/// Where a vertex is in its piece's boundary; none inside the cloth.
std::optional<int> boundaryIndex(const Piece& piece, int vertex);

}  // namespace toile::app
