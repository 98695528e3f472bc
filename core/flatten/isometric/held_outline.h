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

/// OutlineNotHeld if a triangle rules out the outline for any interior: all its corners are on it,
/// it has an area in Q, and would lose all of it or all but a thousandth. Else nothing.
/// @param outline  #n x 2, mm, of piece.boundary's vertices. Cost: linear.
std::optional<Error> blockedBy(const Piece& piece, const Points2& Q, const Points2& outline);

/// The harmonic motion of all vertices for a motion of the outline. Errors: FactorisationFailed,
/// NotFinite, OutOfMemory, Cancelled. Cost: a factorisation of the interior.
Result<Points2> harmonicMotion(const Piece& piece, const Points2& onOutline,
                               const Progress& progress);

/// Moves the outline to given points, bit for bit, and the interior with it; no triangle flips.
/// Moves along the harmonic motion at once, or in stages that end before a triangle loses its area;
/// between stages the energy is lowered a little.
/// @param Q  #V x 2, mm, no flipped triangle
/// Errors: OutlineNotHeld, and those of `harmonicMotion`. Cost: that of `harmonicMotion`, and a
/// factorisation of size 2 #V for each of the few stages if triangles block the way.
Result<Points2> outlineMoved(const Piece& piece, const EnergyModel& model, Points2 Q,
                             const Points2& outline, const Progress& progress);

/// The minimum of the energy with the outline fixed, bit for bit. Rims of holes
/// get the lengths that they have in `flat`.
/// @param start  #V x 2, mm, no flipped triangle
/// @param flat   #V x 2, mm
/// Errors: BoundaryNotConverged (of the rims), OutlineNotHeld, OutOfMemory, Cancelled.
/// Cost: one to three factorisations of size 2 #V. Re-entrant.
Result<DescentResult> lowerInside(const Piece& piece, const EnergyModel& energy,
                                  const Points2& start, const Points2& flat, Quality quality,
                                  const Progress& progress);

}  // namespace toile::isometric
