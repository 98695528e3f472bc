// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/cut/user_cuts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// A dart becomes part of a seam when a cut leads on from its tip, and is a dart again without it.

/// The cut that lets a dart go on as a seam: a path from its tip, in the flat piece straight on
/// along the line from the middle of its mouth to its tip, to where that meets the outline. Points
/// as the pieces are, mm; name and id are left empty. None where the seam is no dart, its piece is
/// not flat, or where a hole is met before.
/// @param results  one per piece  @param seam  index into the graph
/// Cost: linear in the rims of the piece. Pure.
std::optional<UserCut> cutBeyondDart(const Garment& garment, const PieceResults& results, int seam);

/// The path that begins at the tip of a dart that the seam is part of: without it there is a dart
/// again. A tip is where a cut ends within the piece that was cut, not on its rim.
/// @param seam  index into the graph
/// Cost: a tree of boxes of that piece, where several cuts were made in it. Pure.
std::optional<CutId> cutBeyondTip(const Garment& garment, int seam);

}  // namespace toile
