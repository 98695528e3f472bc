// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/isometric/isometric_descent.h"

namespace toile {

struct Piece;

}  // namespace toile

namespace toile::isometric {

/// What makes an outline impossible whatever the interior: a triangle with all its corners on it
/// that has its area in Q and would lose it, or all but a thousandth. OutlineNotHeld, or nothing.
/// @param outline  #n x 2, mm, of piece.boundary's vertices. Cost: linear.
std::optional<Error> blockedBy(const Piece& piece, const Points2& Q, const Points2& outline);

/// How all vertices move where the outline does: harmonically. Errors: FactorisationFailed,
/// NotFinite, OutOfMemory, Cancelled. Cost: a factorisation of the interior.
Result<Points2> harmonicMotion(const Piece& piece, const Points2& onOutline,
                               const Progress& progress);

/// Takes the outline to given points, bit for bit, the interior with it, and no triangle flips: in
/// one go along the harmonic motion, or as far at a time as no triangle loses its area, and in
/// between the energy is lowered a little.
/// @param Q  #V x 2, mm, no flipped triangle
/// Errors: OutlineNotHeld, and those of `harmonicMotion`. Cost: that of `harmonicMotion`, and where
/// triangles stand in the way a factorisation of size 2 #V for each stage, of which there are few.
Result<Points2> outlineMoved(const Piece& piece, Points2 Q, const Points2& outline,
                             const Progress& progress);

/// The least symmetric Dirichlet energy with the outline held, bit for bit. Rims of holes get the
/// lengths that they have in `flat`.
/// @param start  #V x 2, mm, no flipped triangle
/// @param flat   #V x 2, mm
/// Errors: BoundaryNotConverged (of the rims), OutlineNotHeld, OutOfMemory, Cancelled.
/// Cost: one to three factorisations of size 2 #V. Re-entrant.
Result<DescentResult> lowerInside(const Piece& piece, const Points2& start, const Points2& flat,
                                  Quality quality, const Progress& progress);

}  // namespace toile::isometric
