// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/seam/seam_measure.h"

namespace toile {

/// How well the two flat edges of a seam fit each other, the intended ease taken out.
enum class SeamFit {
    Unknown,  ///< not measured: a side is not flat, or the edge is free
    Matches,  ///< to within half a millimetre, less than scissors can tell
    Nearly,   ///< to within 1.6 mm, a sixteenth of an inch: what sewing forgives
    Differs,
};

/// Bounds of |errorMm|.
inline constexpr double kMatchesMm = 0.5, kNearlyMm = 1.6;

/// The measure of a seam; none where a side is not flat yet, or cannot be. A free edge has one,
/// with its length alone.
/// @param seam  an index into the garment's seams  Cost: linear in the two outlines. Pure.
std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam);

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure);

}  // namespace toile
