// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "patch.h"

namespace toile::samples {

/// One finished piece: triangles anti-clockwise seen from outside the garment, vertices in mm.
struct Piece {
    std::string name;
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;
};

/// A garment is its pieces, each with vertices of its own.
struct Garment {
    std::string name;         ///< file name without ending
    std::string description;  ///< one line for the head of the file
    std::vector<Piece> pieces;
};

/// The piece that `patch` holds.
Piece makePiece(std::string name, const Patch& patch);

/// The whole piece of which `half` is one half: mirrored in x, joined along the fold.
Piece unfoldPiece(std::string name, const Patch& half);

/// The same piece for the other side of the body: x with the opposite sign.
Piece mirrorPiece(std::string name, const Piece& piece);

}  // namespace toile::samples
