// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"

namespace toile {

/// A line inside a piece along which it is open though its two edges lie on each other: how a
/// program for texture maps gets a bump flat. Its ends are inside the piece or at another slit; a
/// dart, which begins at the outline, is none.
struct Slit {
    int piece;  ///< index into the pieces
    /// mm, its ends and between them the middles of its edges, as the points of a `UserJoin`.
    std::vector<Eigen::Vector3d> points;
    double length;  ///< mm
};

/// The slits inside the pieces, by piece. The longest rim of a piece is its outline, whatever it
/// lies on. Cost: linear in the triangles, n log n in the edges of rims. Pure.
std::vector<Slit> slitsInside(const Pieces& pieces);

/// Makes every piece with slits anew, both sides of each slit one: the same faces in the same
/// order, and no reference panel, which is open there. One that would be no surface then stays as
/// it is; so does, the same pointer, one without slits.
/// @param pieces  as `divide` gives them, without ids yet  Cost: as above. Pure.
void closeSlits(std::vector<std::shared_ptr<Piece>>& pieces);

}  // namespace toile
