// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/piece.h"
#include "core/prove/line_map.h"

// For the sources of this folder only.
namespace toile::prove {

/// A loop of a piece as we have it.
struct OurLoop {
    Points3 space;
    ClosedLine drawn;  ///< measured on the garment
};

/// The outline, then the rims of the holes.
/// @param flat  of the piece's vertices
/// @param line  of the outline where it is no polygon of its vertices, or null
/// Cost: linear. Pure.
std::vector<OurLoop> ourLoops(const Piece& piece, const Points2& flat, const FlatLine* line);

}  // namespace toile::prove
