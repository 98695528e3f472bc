// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/flatten.h"

namespace toile {

struct FlatteningMemory;

/// One function per published method, all of this shape: a disk in, planar points in the piece's
/// vertex order out, in whatever rotation the method gives. `flatten` chooses, turns the result
/// upright and checks it.

/// [Wang05]: boundary edges keep their 3D lengths exactly, the outline's angles stay as close as
/// that allows to the surface's (eq. 9); interior conformal. Same errors as `flatten`.
Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress);

/// [DMA02]'s natural boundary: the Dirichlet energy minus the signed area is minimal, two boundary
/// vertices far apart in space pinned, or none (`options.freeBoundary`, [MTAD08]); the result is
/// scaled to the 3D perimeter. Boundary edges do not keep their lengths: the partner to compare
/// with. One factorisation of size 2 #V and a few back-substitutions, refined: a flat strip of 2000
/// squares in a row keeps 12 digits.
Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress);

/// [Wang05]'s boundary with angles from the interior curvature instead of evenly: alpha~ = alpha -
/// (flux of u), L u = -K inside, u = 0 on the boundary (Cherrier's formula, [SC17] section 4, for a
/// scale factor of one on the boundary). Lengths exact; interior conformal. One factorisation,
/// three back-substitutions in all.
Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress);

/// Exact boundary lengths and the least symmetric Dirichlet energy over boundary and interior,
/// without flipped triangles; isometric_descent.h does the work, [SS15] is the model. Starts from
/// `flattenCurvature`, or on a circle where that has flips, and is never worse than it, but where
/// the outline would cross itself and is moved apart (a note says so). `options.quality` is the
/// dial. Cost: one to ten factorisations of size 2 #V, or on large pieces as many as of a tenth of
/// that and some conjugate gradients.
/// With what is kept of an earlier flattening (flattening_memory.h, or null) it starts from the
/// positions there, if these suit, and keeps what the next can use: then it is never
/// worse than they are, carried over, and is not compared with `flattenCurvature`; of this it tells
/// the figures (iterations, gap, flips) of the last start that was one.
Result<FlatPiece> flattenIsometric(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, FlatteningMemory* memory);
inline Result<FlatPiece> flattenIsometric(const Piece& piece, const FlattenOptions& options,
                                          const Progress& progress) {
    return flattenIsometric(piece, options, progress, nullptr);
}

/// [YBS04]: a fixed outline, that of `flattenConvex` or `flattenCurvature`
/// (`options.stretchOutline`), the interior's weights divided by the stretch of the vertices until
/// the stretch falls no more. Never more flips, nor with as many more stretch, than the method that
/// gave the outline. A factorisation per step, 1 to 12 steps on the pieces tried.
Result<FlatPiece> flattenStretch(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress);

/// [LPRM02]: least squares conformal map with a free boundary; two boundary vertices far apart
/// along the edges are pinned, which is all that sets it apart from `flattenNatural`. Scaled to the
/// 3D perimeter.
Result<FlatPiece> flattenLscm(const Piece& piece, const FlattenOptions& options,
                              const Progress& progress);

/// [SLMB05] (ABF++): planar angles that differ least from the surface's (abf_angles.h), then the
/// positions that meet them, by least squares. Scaled to the 3D perimeter. A factorisation of size
/// 2 #interior per step, 2 to 11 steps on most pieces.
Result<FlatPiece> flattenAbf(const Piece& piece, const FlattenOptions& options,
                             const Progress& progress);

/// The outline on a circle with exact edge lengths, the interior by mean value weights [Flo03]:
/// no flipped triangle, much distortion. Tutte's weights where rounding flips one all the same.
Result<FlatPiece> flattenConvex(const Piece& piece, const FlattenOptions& options,
                                const Progress& progress);

}  // namespace toile
