// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"

namespace toile {

/// A line inside a piece along which it is open although its two edges coincide: texture map
/// programs flatten a bump in this way. Its ends are inside the piece or at another slit; a dart is
/// not a slit, because it starts at the outline.
struct Slit {
    int piece;  ///< index into the pieces
    /// mm, its ends and between them the midpoints of its edges, like the points of a `UserJoin`.
    std::vector<Eigen::Vector3d> points;
    double length;  ///< mm
};

/// The slits inside the pieces, by piece. The longest rim of a piece is its outline, whatever it
/// lies on. Cost: linear in the triangles, n log n in the edges of rims. Pure.
std::vector<Slit> slitsInside(const Pieces& pieces);

/// Replaces every piece with slits by one with both sides of each slit merged: the same faces in
/// the same order, without the reference panel, which is open there. A piece that would not be a
/// surface, and one without slits, keeps its pointer.
/// @param pieces  as `divide` gives them, without ids yet  Cost: as above. Pure.
void closeSlits(std::vector<std::shared_ptr<Piece>>& pieces);

}  // namespace toile
