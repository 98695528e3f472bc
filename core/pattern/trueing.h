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

/// An end of a seam, where the lines that meet it on either side run on into each other once it is
/// sewn: armhole over the shoulder seam, hem over the side seam.
struct SeamEnd {
    int seam = -1;              ///< index into the graph
    bool atEnd = false;         ///< where its left side ends; false: where it starts
    OutlineCorner left, right;  ///< the same one where a dart's sides start at one point
    double kink = 0;            ///< inner angles of both sides less a straight one, radians
    bool isTrued = false;       ///< it is to be taken out
};

/// The inner angles of two corners less a straight one, from what their lines turn by there.
double kinkOf(double turnLeft, double turnRight);

/// What the outline turns by at a turn point as it is drawn: where there is no line, exactly.
double drawnTurn(const PieceResult& result, const TurnPoint& point);

/// Ends of seams whose two sides both turn a corner there, by seam. A kink beyond kMaxKink is a
/// corner that is meant, and is not listed.
/// @param segments  one per piece  Cost: seams times turn points of their pieces. Pure.
std::vector<SeamEnd> findSeamEnds(const Garment& garment,
                                  const std::vector<OutlineSegments>& segments,
                                  const LineSettings& settings);

/// Larger kinks are meant, radians.
inline constexpr double kMaxKink = 0.3490658503988659;  ///< 20 degrees

/// The least change of corner angles that takes out the kinks of all ends that are to be trued, in
/// the sense of least squares: sum of the two inner angles = a straight one, for every one of them.
/// @return per piece, per turn point: by how much its turn grows, radians (its inner angle falls)
/// Cost: cubic in the ends that hang together, which are few. Pure.
std::vector<std::vector<double>> truedTurns(const std::vector<OutlineSegments>& segments,
                                            const std::vector<SeamEnd>& ends);

}  // namespace toile
