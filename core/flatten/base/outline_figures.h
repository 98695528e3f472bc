// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/garment/piece.h"
#include "core/quality/piece_quality.h"

namespace toile {

/// The figures of the outline as it is drawn, against the lengths that it is to have: perimeter,
/// length errors, crossings. Nothing changes where it is the polygon of its vertices with its
/// lengths in 3D. Linear, but for crossings. Pure.
void measureOutline(const Piece& piece, const FlatPiece& flat, const OutlineTargets& targets,
                    PieceQuality& quality);

}  // namespace toile
