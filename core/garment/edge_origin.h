// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/id.h"
#include "core/io/up_axis.h"

namespace toile {

struct Piece;

/// Where an edge of a piece's rim comes from: a stretch of a rim of the division, or one side of a
/// cut. Places are shares of that line's length, 0 to 1, so that they stay where the garment is
/// read in another unit. A rim runs with the surface on its left, from the least of its vertices by
/// the file's coordinates; on the right side of a cut from > to.
struct EdgeOrigin {
    int tail = -1, head = -1;  ///< vertices of the piece, surface on the left
    LineId line;
    CutId cut;  ///< none where the line is a rim of the division
    double from = 0, to = 0;
};

/// The line that a cut is.
LineId lineOf(CutId cut);

/// The origins of a piece as it was divided: its own rims, known by its id and by where they begin.
/// Rims that do not close, as those of a surface that is no manifold, have none.
/// @param up  of the file  @return sorted by tail  Cost: linear. Pure.
std::vector<EdgeOrigin> rimOrigins(const Piece& piece, UpAxis up);

/// The origin of the rim edge that leaves a vertex; null where it is not known.
const EdgeOrigin* originAt(const std::vector<EdgeOrigin>& origins, int tail);

}  // namespace toile
