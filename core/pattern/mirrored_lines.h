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
/// other falls by one, linearly from row to row. Arc lengths in 3D, mm.
struct MirrorPlaces {
    std::vector<double> rising{}, falling{};  ///< as many

    /// The place that mirrors one of the first outline, counted on over turns.
    double operator()(double place) const;
    bool operator==(const MirrorPlaces&) const = default;
};

/// Of a piece that is to be a mirror image: the line it follows from. Two that mirror each other
/// follow from the same one, which is drawn for either in the same way.
struct MirroredOutline {
    OutlineReference reference{};  ///< of the leading one
    MirrorPlaces places{};         ///< from the leading one's outline to the other's
    bool isImage = false;          ///< this is the other
    bool isSymmetric = false;      ///< there is no other: it is symmetric in itself
    PieceId lead{};                ///< the leading one

    bool operator==(const MirroredOutline&) const = default;
};

/// A piece that is to be a mirror image, and the piece that leads: itself, or its counterpart.
struct MirrorPlan {
    int lead = -1;  ///< -1: it is none, and keeps its own line
    MirroredOutline outline{};
};

/// Two segments whose lengths in the plane differ by more than this are no mirror images, mm.
inline constexpr double kSameLength = 1e-6;

/// Which pieces are drawn as mirror images of each other, and near which line: those that are
/// flat, whose segments all correspond in the opposite order, and are as long as each other
/// (`outlineTargets`). The one on the side to which the plane's normal points leads. Others keep
/// their own lines, as do outlines that are one segment.
/// @param exact  one per piece, as solved  @param mirror  not None
/// @return one per piece  Cost: a boundary problem for every pair. Pure.
std::vector<MirrorPlan> planMirrors(const Garment& garment, const PieceResults& exact,
                                    const Symmetry& symmetry, Mirror mirror);

/// The reference as a line; of a pair, the leading one's.
FlatLine lineOf(const OutlineReference& reference);

/// A line that was drawn for the leading piece as it is for this one: as it is, mirrored node by
/// node, or symmetric in itself. Each length is kept.
/// Errors: those of `symmetricLine`.  Cost: linear, or a boundary problem. Pure.
Result<FlatLine> mirroredFor(const MirroredOutline& outline, FlatLine line);

}  // namespace toile
