// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/corners.h"
#include "core/pattern/line_settings.h"

namespace toile {

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
