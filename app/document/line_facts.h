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

/// Refers to a segment of a garment.
struct SegmentAt {
    int piece = -1, segment = -1;

    bool operator==(const SegmentAt&) const = default;
};

/// How the drawn outlines differ from the exact ones. Lengths in mm.
struct DrawnFacts {
    double farthest = 0;                 ///< farthest a drawn line is from the exact outline
    double exactStrain = 0, strain = 0;  ///< largest strain of an edge, before and after drawing
    bool drawn = false;                  ///< some piece has a drawn line
};

/// @param results  one per piece, or empty; those of other pieces are ignored. Cost: linear. Pure.
DrawnFacts drawnFacts(const Garment& garment, const PieceResults& results);

/// Facts about the lines of a garment. Angles in radians, lengths in mm.
struct LineFacts : DrawnFacts {
    std::vector<OutlineSegments> segments;  ///< one per piece; empty if not flat
    std::vector<SeamEnd> ends;              ///< the largest kink first
    std::vector<double> kept;               ///< kinks of the drawn lines at these ends

    const Segment& at(const SegmentAt& one) const {
        return segments[static_cast<std::size_t>(one.piece)]
            .segments[static_cast<std::size_t>(one.segment)];
    }
};

/// Cost: linear in outlines and seams. Pure.
/// @param results  one per piece, or empty; those of other pieces are ignored
LineFacts lineFacts(const Garment& garment, const PieceResults& results, const LineSettings& lines);

/// The segment that covers most of a marked stretch, or that holds a marked vertex or begins there.
std::optional<SegmentAt> segmentAt(const Garment& garment, const LineFacts& facts,
                                   const Feature& mark);
/// The segment that covers most of a seam's left side.
std::optional<SegmentAt> segmentOfSeam(const LineFacts& facts, const Seam& seam);
/// The segment that is sewn to the middle of this one; none if that edge is free.
std::optional<SegmentAt> partnerOf(const Garment& garment, const LineFacts& facts,
                                   const SegmentAt& one);

/// The segment that covers the mirror image of the middle of this one; none without a counterpart.
/// @param symmetry  of the garment
std::optional<SegmentAt> mirrorOf(const Garment& garment, const LineFacts& facts,
                                  const Symmetry& symmetry, const SegmentAt& one);

/// The turn point at a vertex of a piece's outline; null if there is none.
/// @param at  index into Piece::boundary
const TurnPoint* turnPointOf(const Piece& piece, const OutlineSegments& segments, int at);

/// The index of a vertex in its piece's boundary; none inside the cloth.
std::optional<int> boundaryIndex(const Piece& piece, int vertex);

}  // namespace toile::app
