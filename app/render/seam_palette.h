// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "app/render/colour_map.h"
#include "core/garment/seam.h"

namespace toile {

/// Colours of seam lines: stronger than any cloth's, told apart from each other, and neither the
/// yellow nor the magenta of what is selected.
inline constexpr int kSeamColours = 10;
/// @param onDark  the lighter ones, for a dark ground; the same hues in the same order
const std::array<Rgb, kSeamColours>& seamPalette(bool onDark = false);

/// Per seam an index into the palette, -1 for free edges. Both sides of a seam have its colour, and
/// no other seam on either of their pieces, so that one finds what an edge is sewn to; where a
/// piece has more seams than there are colours, at least no other between the same two pieces while
/// that goes. Of what is left the colours least in use, and among those the one that the seam's
/// name chooses. Cost: linear in the seams. Pure.
std::vector<int> seamColours(const SeamGraph& seams);

}  // namespace toile
