// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/base/stopwatch.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"

namespace toile {

/// What the methods without a fixed outline share.

/// Two boundary vertices far apart in space: the farthest from the outline's middle, then each in
/// turn the farthest from the other until the distance no longer grows. Cost: linear. Pure.
std::array<int, 2> farPairInSpace(const Piece& piece);

/// Two boundary vertices far apart along the mesh's edges: the same search with the shortest edge
/// paths. A rolled piece is long this way. Cost: a few times #E log #V. Pure.
std::array<int, 2> farPairAlongEdges(const Piece& piece);

/// The result of a free-boundary method: points scaled so that the outline has the 3D perimeter,
/// and the outline's angle energy. Errors: NotFinite (a collapsed or broken outline).
Result<FlatPiece> atTrueSize(const Piece& piece, const Points2& points, const Stopwatch& time);

}  // namespace toile
