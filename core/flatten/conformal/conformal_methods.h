// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"

namespace toile {

struct Piece;

/// One function per published method, here and in reference/, all of this shape: a disk in, planar
/// points in the piece's vertex order out, in any rotation. `flatten` chooses the method, turns the
/// result upright and checks it. Methods that keep lengths also accept other lengths than those in
/// 3D; angles and curvature stay those of the surface.

/// [Wang05]: boundary edges keep their 3D lengths exactly, the outline's angles stay as close to
/// the surface's as possible (eq. 9); interior conformal. Same errors as `flatten`.
Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress, const OutlineTargets& targets = {});

/// [Wang05]'s boundary with angles from the interior curvature instead of evenly: alpha~ = alpha -
/// (flux of u), L u = -K inside, u = 0 on the boundary (Cherrier's formula, [SC17] section 4, for a
/// scale factor of one on the boundary). Lengths exact; interior conformal. One factorisation,
/// three back-substitutions in all.
Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, const OutlineTargets& targets = {});

/// [DMA02]'s natural boundary: minimises the Dirichlet energy minus the signed area, with two
/// boundary vertices far apart in space pinned, or none (`options.freeBoundary`, [MTAD08]); the
/// result is scaled to the 3D perimeter. For comparison: boundary edges do not keep their lengths.
/// One factorisation of size 2 #V and a few back-substitutions, refined: a flat strip of 2000
/// squares in a row keeps 12 digits.
Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress);

/// [LPRM02]: least squares conformal map with a free boundary; differs from `flattenNatural` only
/// in that the two pinned boundary vertices are far apart along the edges. Scaled to the 3D
/// perimeter.
Result<FlatPiece> flattenLscm(const Piece& piece, const FlattenOptions& options,
                              const Progress& progress);

}  // namespace toile
