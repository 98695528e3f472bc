// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"

namespace toile {

struct Piece;

/// Methods for comparison, with the interface described in conformal_methods.h.

/// The outline on a circle with exact edge lengths, the interior by mean value weights [Flo03]: no
/// flipped triangle, much distortion. Tutte's weights if rounding flips a triangle anyway.
Result<FlatPiece> flattenConvex(const Piece& piece, const FlattenOptions& options,
                                const Progress& progress, const OutlineTargets& targets = {});

/// [YBS04]: a fixed outline, that of `flattenConvex` or `flattenCurvature`
/// (`options.stretchOutline`); the interior's weights are divided by the stretch of the vertices
/// until it stops falling. Never has more flips, or as many with more stretch, than the method of
/// the outline. A factorisation per step, 1 to 12 steps on the pieces tried.
Result<FlatPiece> flattenStretch(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress, const OutlineTargets& targets = {});

/// [SLMB05] (ABF++): planar angles closest to the surface's (abf_angles.h), then positions for
/// them, by least squares. Scaled to the 3D perimeter. A factorisation of size 2 #interior per
/// step, 2 to 11 steps on most pieces.
Result<FlatPiece> flattenAbf(const Piece& piece, const FlattenOptions& options,
                             const Progress& progress);

}  // namespace toile
