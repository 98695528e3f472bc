// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/outline_reference.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// Places on two outlines, or twice on one, that mirror each other: while one rises by a turn the
/// other falls by a turn, linearly from row to row. Arc lengths in 3D, mm.
struct MirrorPlaces {
    std::vector<double> rising{}, falling{};  ///< of equal size

    /// The mirrored place of a place on the first outline, counted on over turns.
    double operator()(double place) const;
    bool operator==(const MirrorPlaces&) const = default;
};

/// Line of a piece that is to be a mirror image. Two that mirror each other share the same line,
/// which is drawn in the same way for both.
struct MirroredOutline {
    OutlineReference reference{};  ///< of the leading piece
    MirrorPlaces places{};         ///< from the leading piece's outline to the other's
    bool isImage = false;          ///< this is the other piece
    bool isSymmetric = false;      ///< there is no other piece: it is symmetric in itself
    PieceId lead{};                ///< the leading piece

    bool operator==(const MirroredOutline&) const = default;
};

/// A piece that is to be a mirror image, and the leading piece: itself or its counterpart.
struct MirrorPlan {
    int lead = -1;  ///< -1: not mirrored, keeps its own line
    MirroredOutline outline{};
};

/// Segments whose lengths in the plane differ by more than this are no mirror images, mm.
inline constexpr double kSameLength = 1e-6;

/// Plans which pieces are drawn as mirror images of each other, and near which line: pieces that
/// are flat, whose segments all correspond in the opposite order, with equal lengths
/// (`outlineTargets`). The piece on the side of the plane's normal leads. Others keep their own
/// lines, as do outlines of a single segment.
/// @param exact  one per piece, as solved  @param mirror  not None
/// @return one per piece  Cost: a boundary problem for every pair. Pure.
std::vector<MirrorPlan> planMirrors(const Garment& garment, const PieceResults& exact,
                                    const Symmetry& symmetry, Mirror mirror);

/// The reference as a line; of a pair, that of the leading piece.
FlatLine lineOf(const OutlineReference& reference);

/// Adapts a line drawn for the leading piece to this one: unchanged, mirrored node by node, or
/// symmetric in itself. Each length is kept.
/// Errors: those of `symmetricLine`.  Cost: linear, or a boundary problem. Pure.
Result<FlatLine> mirroredFor(const MirroredOutline& outline, FlatLine line);

}  // namespace toile
