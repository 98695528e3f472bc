// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// Whether a piece cannot lie flat for a reason that cuts can solve.
bool isOpenable(const Piece& piece);

/// The automatic cuts (`proposeCuts`) that open one piece, as if the user had drawn them, so that
/// they can be kept, moved and removed like any other; `cutPieces` would open all pieces that
/// cannot lie flat. Each has few points if the shortest paths between these follow the same lines.
/// @param isWhole  the piece is as divided and joined; a piece made by other cuts keeps all points
///                 of the lines, since cuts are drawn on the surface before them
/// @return  in mm, without names and ids; applied to the piece they leave one disk
/// @errors  those of `proposeCuts`; a cut error if no cuts achieve that; Cancelled
/// Cost: that of the cuts, up to three times. Deterministic. Re-entrant.
Result<std::vector<UserCut>> openingCuts(const Piece& piece, bool isWhole,
                                         const Progress& progress = Progress());

}  // namespace toile
