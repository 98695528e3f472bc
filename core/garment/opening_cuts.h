// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// Whether a piece cannot lie flat for a reason that cuts may repair.
bool isOpenable(const Piece& piece);

/// Cuts that open one piece, where `cutPieces` would open all that cannot lie flat: its automatic
/// cuts (`proposeCuts`) as a person would have drawn them, to be kept, moved and taken back like
/// any other. Few points each where the shortest ways between these are the same lines.
/// @param isWhole  the piece is as it was divided and joined; one that other cuts have made keeps
///                 all points of the lines, since cuts are drawn on what was there before them
/// @return  in mm, without names and ids; made in the piece they leave one disk
/// @errors  those of `proposeCuts`; a cut error where no cuts do that; Cancelled
/// Cost: that of the cuts, up to three times. Deterministic. Re-entrant.
Result<std::vector<UserCut>> openingCuts(const Piece& piece, bool isWhole,
                                         const Progress& progress = Progress());

}  // namespace toile
