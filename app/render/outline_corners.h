// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/piece.h"

namespace toile {

/// The least turn at a corner of an outline, radians: 40 degrees. A curve, drawn by short edges,
/// turns by less at each.
inline constexpr double kCornerTurn = 0.6981317007977318;

/// Where the outline turns sharply, measured in the cloth: places in Piece::boundary, ascending.
/// Cost: linear in the faces. Pure.
std::vector<int> outlineCorners(const Piece& piece);

/// A stretch of an outline: edge k runs from boundary[k] to boundary[k + 1].
struct OutlineRun {
    int first = 0;
    int count = 0;  ///< of edges; the last may be past the outline's beginning
};

/// From corner to corner around an edge of the outline; all of it where there are fewer than two
/// corners. Precondition: 0 <= edge < size.
OutlineRun runBetweenCorners(const std::vector<int>& corners, int size, int edge);

}  // namespace toile
