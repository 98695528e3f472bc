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

/// Where one segment of an outline ends and the next begins.
struct TurnPoint {
    double at = 0;           ///< arc length in 3D along the outline, mm
    double turn = 0;         ///< of the exact flat outline there, radians; positive to the left
    bool isCorner = false;   ///< by the rule of corners.h, or by hand
    bool isSeamEnd = false;  ///< of a seam or a free edge
    bool byHand = false;     ///< a person has put it there
};

/// Whether the line keeps the turn there: at corners, and at ends of seams that turn by more than
/// 15 degrees. These may be kinks of the designer's; other ends of seams are smoothed over.
inline bool keepsTurn(const TurnPoint& point) {
    constexpr double kKink = 0.2617993877991494;  // 15 degrees
    return point.isCorner || (point.isSeamEnd && !point.byHand && std::abs(point.turn) > kKink);
}

/// A stretch of outline from one turn point to the next, along the outline.
struct Segment {
    SeamSide at;               ///< not reversed; `loop` 0
    int seam = -1;             ///< that it is part of, index into the graph; -1: of none
    bool isRight = false;      ///< of that seam's sides
    LineStretch place{};       ///< by which it is known again, whatever is cut elsewhere
    SegmentSettings settings;  ///< what has been said of it; `place` as above

    double length() const { return at.length(); }
};

/// The outline of a flat piece from turn point to turn point. Segment k runs from turn point k to
/// the next one; the last one passes the outline's first vertex where that is no turn point.
struct OutlineSegments {
    std::vector<TurnPoint> turnPoints;  ///< by `at`, in [0, perimeter)
    std::vector<Segment> segments;      ///< as many; one, from 0 to 0 again, where there is none
};

/// The results as they were solved; null where a piece is not flat, or has another shape now.
PieceResults exactResults(const Garment& garment, const PieceResults& results);

/// The segments of every piece: ends of seams and free edges, corners, and what a person has added
/// or taken away. @param results  one per piece, as solved (`PieceResult::exact`)
/// @return one per piece; nothing where a piece is not flat  Cost: outlines and settings. Pure.
std::vector<OutlineSegments> findSegments(const Garment& garment, const PieceResults& results,
                                          const LineSettings& settings);

}  // namespace toile
