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

/// Places that mirror each other on two outlines, or on one: `rising` rises by a turn while
/// `falling` falls by a turn, linearly between rows. Arc lengths in 3D, mm.
struct MirrorPlaces {
    std::vector<double> rising{}, falling{};  ///< of equal size

    /// The mirrored place of a place on the first outline; continues beyond whole turns.
    double operator()(double place) const;
    bool operator==(const MirrorPlaces&) const = default;
};

/// Line of a piece that is drawn as a mirror image. Two mirrored pieces share the same line, which
/// is drawn in the same way for both.
struct MirroredOutline {
    OutlineReference reference{};  ///< of the leading piece
    MirrorPlaces places{};         ///< from the leading piece's outline to the other's
    bool isImage = false;          ///< this is the other piece
    bool isSymmetric = false;      ///< there is no other piece: it mirrors itself
    PieceId lead{};                ///< the leading piece

    bool operator==(const MirroredOutline&) const = default;
};

/// A piece to draw as a mirror image, and the leading piece: itself or its counterpart.
struct MirrorPlan {
    int lead = -1;  ///< -1: not mirrored, keeps its own line
    MirroredOutline outline{};
};

/// Segments are mirror images if their lengths in the plane differ by at most this, mm.
inline constexpr double kSameLength = 1e-6;

/// Plans which pieces are drawn as mirror images of each other, and near which line. These are flat
/// pieces whose segments all correspond in the opposite order, with equal lengths
/// (`outlineTargets`). The piece on the side of the plane's normal leads. Other pieces and outlines
/// of a single segment keep their own lines.
/// @param exact  one per piece, as solved  @param mirror  not None
/// @return one per piece  Cost: a boundary problem for every pair. Pure.
std::vector<MirrorPlan> planMirrors(const Garment& garment, const PieceResults& exact,
                                    const Symmetry& symmetry, Mirror mirror);

/// The reference as a line; for a pair, the line of the leading piece.
FlatLine lineOf(const OutlineReference& reference);

/// Adapts a line drawn for the leading piece to this one: unchanged, mirrored node by node, or
/// symmetric in itself. Each length is kept.
/// Errors: those of `symmetricLine`.  Cost: linear, or a boundary problem. Pure.
Result<FlatLine> mirroredFor(const MirroredOutline& outline, FlatLine line);

}  // namespace toile
