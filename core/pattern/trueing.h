// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/segments.h"

namespace toile {

/// A turn point of a piece's outline.
struct OutlineCorner {
    int piece = -1;
    int point = -1;  ///< index into OutlineSegments::turnPoints
};

/// An end of a seam, where the adjoining lines on either side continue each other once it is sewn:
/// armhole over the shoulder seam, hem over the side seam.
struct SeamEnd {
    int seam = -1;              ///< index into the graph
    bool atEnd = false;         ///< at the end of its left side; false: at its start
    OutlineCorner left, right;  ///< equal if a dart's sides start at the same point
    double kink = 0;            ///< inner angles of both sides less a straight angle, radians
    bool isTrued = false;       ///< it is to be removed
};

/// The inner angles of two corners less a straight angle, given the turns of their lines.
double kinkOf(double turnLeft, double turnRight);

/// The turn of the drawn outline at a turn point; of the exact outline if there is no line.
double drawnTurn(const PieceResult& result, const TurnPoint& point);

/// Ends of seams with a corner on both sides, by seam. A kink beyond kMaxKink is an intended corner
/// and is not listed.
/// @param segments  one per piece  Cost: seams times turn points of their pieces. Pure.
std::vector<SeamEnd> findSeamEnds(const Garment& garment,
                                  const std::vector<OutlineSegments>& segments,
                                  const LineSettings& settings);

/// Larger kinks are intended, radians.
inline constexpr double kMaxKink = 0.3490658503988659;  ///< 20 degrees

/// The smallest change of corner angles, in the sense of least squares, that removes the kinks of
/// all ends to be trued: the two inner angles of each add up to a straight one.
/// @return per piece, per turn point: increase of its turn, radians (its inner angle decreases)
/// Cost: cubic in connected ends, which are few. Pure.
std::vector<std::vector<double>> truedTurns(const std::vector<OutlineSegments>& segments,
                                            const std::vector<SeamEnd>& ends);

}  // namespace toile
