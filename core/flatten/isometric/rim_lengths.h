// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"

namespace toile {

struct Piece;

/// Gives the rims of a piece's holes the lengths they have on the garment: the isometric descent
/// goes on with the edges of every rim among its conditions, and without the caps that filled the
/// holes. A patch is sewn to the rim that it was cut from, so both must be equally long.
/// Where no such flattening is near (`isNear`), or a rim or the outline would cross itself, `flat`
/// stays as it is, and a note (RimsNotKept) tells how far the rim is off that is furthest so.
/// @param piece  a disk with holes, mm
/// @param flat   the isometric flattening of the piece with its holes filled, less the caps
/// Errors: OutOfMemory, Cancelled. Cost: that of a descent with a good start. Re-entrant.
Result<void> keepRimLengths(const Piece& piece, Quality quality, FlatPiece& flat,
                            const Progress& progress);

}  // namespace toile
