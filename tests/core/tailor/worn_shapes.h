// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// Garments of one skin, as a front and a back of squares of 20 mm that hang together along their
/// outlines but for the openings, and bulge by up to 80 mm between them. Mirror images of
/// themselves in x = 0; y up, the front towards z.

/// Trunk of 400 by 600 mm, sleeves of 160 by 160 at its top; the neck is lower in front. Armpits at
/// (+-200, 440, 0).
MeshArrays wornShirt();
/// Trunk of 400 by 400 mm, lower in front, over two legs of 180 by 400; the crotch at (0, 400, 0).
MeshArrays wornTrousers();
/// A tube that widens from 300 to 700 mm of width over 600 of height.
MeshArrays wornSkirt(int around = 64, int along = 30);

/// A garment of one skin, as if it had been read.
std::shared_ptr<const Piece> wornPiece(MeshArrays mesh);

}  // namespace toile::test
