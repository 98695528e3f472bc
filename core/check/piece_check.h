// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/readiness.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/project/piece_settings.h"

namespace toile {

/// One piece of a garment, as it is to be cut.
struct PieceToCut {
    int index;  ///< in the garment
    const PieceResult& result;
    PieceSettings settings;  ///< without anchors
    const Fabric& fabric;
};

/// Parts of a piece's area beyond the fabric's limits along one direction: from the first on it is
/// a doubt, from the second on a fault. Less is a matter of single triangles.
inline constexpr double kStrainDoubtShare = 0.01, kStrainFaultShare = 0.05;

/// What there is to say of the piece alone: not flat, outline, flips, strain, grain, and the notes
/// of its flattening. Cost: linear in the triangles, n log n in an outline that crosses itself.
/// Pure.
void checkPiece(const PieceToCut& piece, FindingList& found);

}  // namespace toile
