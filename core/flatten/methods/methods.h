// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/flatten.h"

namespace toile {

/// One function per published method, all of this shape: a disk in, planar points in the piece's
/// vertex order out, in whatever rotation the method gives. `flatten` chooses, turns the result
/// upright and checks it.

/// [Wang05]: boundary edges keep their 3D lengths exactly, the outline's angles stay as close as
/// that allows to the surface's (eq. 9); interior conformal. Same errors as `flatten`.
Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress);

/// [DMA02]'s natural boundary: the conformal energy minus the signed area is minimal, two far
/// boundary vertices pinned; the result is scaled to the 3D perimeter. Boundary edges do not keep
/// their lengths: the partner to compare with. One factorisation of size 2 #V, whose condition
/// grows with the piece's slenderness: a flat strip of 2000 squares in a row keeps 4 digits only.
Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress);

}  // namespace toile
