// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/cut/user_cuts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile {

/// A dart becomes part of a seam if a cut continues from its tip, and is a dart again without it.

/// The cut that continues a dart as a seam: a path from its tip in the flat piece, straight along
/// the line from the middle of its mouth through its tip, to the outline. Points are in the pieces'
/// coordinates, mm; name and id are empty. Nothing if the seam is no dart, if its piece is not
/// flat, or if the path meets a hole first.
/// @param results  one per piece  @param seam  index into the graph
/// Cost: linear in the rims of the piece. Pure.
std::optional<UserCut> cutBeyondDart(const Garment& garment, const PieceResults& results, int seam);

/// The path that starts at the tip of a dart that the seam is part of; without it the dart is
/// restored. A tip is a cut's end inside the piece that was cut, not on its rim.
/// @param seam  index into the graph
/// Cost: a tree of boxes of that piece if several cuts were made in it. Pure.
std::optional<CutId> cutBeyondTip(const Garment& garment, int seam);

}  // namespace toile
