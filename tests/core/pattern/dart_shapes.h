// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/pattern/pattern.h"

namespace toile::test {

/// Rows of an outline: where a dart's first leg begins, its tip, where its second leg ends.
struct DartRows {
    int from = 0, tip = 0, to = 0;
};

using Corners = std::vector<Eigen::Vector2d>;

Points2 asOutline(const Corners& points);

/// A piece with darts, numbered from 1. Segments run from each of `turns` and of the darts' rows to
/// the next; they are seams of no number but on the darts.
PatternPiece pieceWithDarts(const Corners& outline, const std::vector<DartRows>& darts,
                            std::vector<int> turns);

/// A dart as it is when closed, in the lower edge of a piece 300 mm high.
struct ClosedDart {
    Corners left;  ///< the lower edge, from its corner to the mouth
    Eigen::Vector2d mouth, tip;
    Corners right;  ///< from the mouth to the other corner
    double angle;   ///< by which the left part is turned about the tip to open the dart
    Corners leg{};  ///< between mouth and tip, of both legs

    PatternPiece opened() const;
};

/// The outline begun at another of its points.
PatternPiece begunAt(const PatternPiece& piece, int row);
/// Every point turned about the origin, then moved; the grain too.
PatternPiece moved(PatternPiece piece, double angle, const Eigen::RowVector2d& by);
/// The mirror image in the y axis, which runs the other way round.
PatternPiece mirrored(PatternPiece piece);

}  // namespace toile::test
