// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Tutte's embedding [Tut63] with the piece's boundary lengths: the outline of `circleOutline`,
/// every interior vertex at the mean of its neighbours. The outline is strictly convex and the
/// weights are positive, so no triangle is flipped in exact arithmetic; a chord
/// between boundary vertices does no harm. In doubles, triangles far from a short boundary can
/// become smaller than rounding: count flips where that matters.
/// @param piece  a disk (no defect, holes filled), mm  @return #V x 2, mm
/// Errors: NoClosedOutline, FactorisationFailed, OutOfMemory, NotFinite, Cancelled.
/// Cost: one factorisation of the interior, two back-substitutions. Re-entrant.
Result<Points2> tutteOnCircle(const Piece& piece, const Progress& progress);

}  // namespace toile
