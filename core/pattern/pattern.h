// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;
struct FlatPiece;

/// One flat piece as a pattern maker knows it. Millimetres, y up, the fabric's right side facing
/// the reader, never mirrored.
struct PatternPiece {
    std::string name;  ///< as in the garment
    std::string id;    ///< unique slug, stable for the same garment
    Points2 outline;   ///< net outline (seam line), anti-clockwise, first vertex not repeated
};

struct Pattern {
    std::string name;  ///< of the garment
    std::vector<PatternPiece> pieces;
};

/// The net outline of a flattened piece, in boundary order.
PatternPiece makePatternPiece(const Piece& piece, const FlatPiece& flat);

/// Pieces whose names give the same slug get "-2", "-3" in pattern order.
void makeIdsUnique(Pattern& pattern);

}  // namespace toile
