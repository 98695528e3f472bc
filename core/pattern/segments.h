// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/geometry/line.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/line_settings.h"

namespace toile {

/// A place on a line is a corner if the turn between the chords before and after exceeds an angle.
struct TurnLimit {
    double chord = 0;  ///< length of either chord, mm; shorter if a sharp corner is closer
    double turn = 0;   ///< radians
};

// Corners of outlines. Where the seam changes (another partner begins, the partner's edge is not
// the neighbour of the previous one, or a free edge begins) a corner is likely, and long chords
// find blunt ones under wrinkles. Elsewhere most turns are wrinkles or curves, and only sharp turns
// are corners. Measured on 13 garments with known panels, which have 435 corners of more than 25
// degrees, 382 of them where the seam changes:
//
// | where the seam changes | elsewhere         | recall | precision |
// |------------------------|-------------------|-------:|----------:|
// | 5 mm > 25 degrees      | 5 mm > 25 degrees |  0.993 |     0.866 |
// | 15 mm > 25 degrees     | 5 mm > 45 degrees |  0.970 |     0.961 |
inline constexpr TurnLimit kSeamChangeCorner{15, 0.4363323129985824};  ///< 25 degrees
inline constexpr TurnLimit kPlainCorner{5, 0.7853981633974483};        ///< 45 degrees
/// For lines without known seams, such as those of pattern files: an extra corner does no harm if
/// corners are only paired or marked.
inline constexpr TurnLimit kLineCorner{5, 0.4363323129985824};  ///< 25 degrees
/// Minimum distance between two corners, mm.
inline constexpr double kOneCorner = 1;

/// The turn between the chords of given lengths before and after a place, radians, positive to the
/// left.
double chordTurn(const geometry::Line& line, double at, double before, double after);

/// Finds the vertices of a closed line that are corners by a limit: among vertices whose chords
/// turn by more, the one with the strongest own turn within a chord length. Two closer vertices are
/// both corners if each turns by more than the limit at the vertex itself.
/// @param points  #n x 2, mm  @return vertices, ascending  Cost: n log n. Pure.
std::vector<int> findCorners(const Points2& points, const TurnLimit& limit = kLineCorner);

/// The point where a segment of an outline ends and the next starts.
struct TurnPoint {
    double at = 0;           ///< arc length in 3D along the outline, mm
    double turn = 0;         ///< of the exact flat outline, radians; positive to the left
    bool isCorner = false;   ///< by the rule of corners.h, or by hand
    bool isSeamEnd = false;  ///< of a seam or a free edge
    bool byHand = false;     ///< the user placed it
};

/// Whether the line keeps the turn: at corners, and at ends of seams that turn by more than 15
/// degrees, which may be intended kinks. Other ends of seams are smoothed.
inline bool keepsTurn(const TurnPoint& point) {
    constexpr double kKink = 0.2617993877991494;  // 15 degrees
    return point.isCorner || (point.isSeamEnd && !point.byHand && std::abs(point.turn) > kKink);
}

/// A stretch of outline between successive turn points, along the outline.
struct Segment {
    SeamSide at;               ///< not reversed; `loop` 0
    int seam = -1;             ///< index into the graph of the seam that it is part of; -1: none
    bool isRight = false;      ///< side of that seam
    LineStretch place{};       ///< identifies it again, whatever is cut elsewhere
    SegmentSettings settings;  ///< its settings; `place` as above
    EdgeKind foundEdge =
        EdgeKind::Unknown;  ///< if it is free: its kind by its place (edge_kinds.h)
    int opening = -1;       ///< if it is free: number of the garment's opening that it belongs to

    /// Kind of a free edge, set or found.
    EdgeKind edge() const { return settings.edge.value_or(foundEdge); }
    double length() const { return at.length(); }
};

/// The segments of a flat piece's outline. Segment k runs from turn point k to the next; the last
/// one passes the outline's first vertex if that is no turn point.
struct OutlineSegments {
    std::vector<TurnPoint> turnPoints;  ///< sorted by `at`, in [0, perimeter)
    std::vector<Segment> segments;      ///< as many; without turn points one, from 0 to 0
};

/// The results as solved; null if a piece is not flat, or has another shape now.
PieceResults exactResults(const Garment& garment, const PieceResults& results);

/// The segments of every piece: ends of seams and free edges, corners, and the user's changes.
/// @param results  one per piece, as solved (`PieceResult::exact`)
/// @return one per piece; empty if a piece is not flat  Cost: outlines and settings. Pure.
std::vector<OutlineSegments> findSegments(const Garment& garment, const PieceResults& results,
                                          const LineSettings& settings);

}  // namespace toile
