// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/segments.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// How rough the exact outlines are: the median change of curvature from one vertex to the next,
/// of vertices 20 mm apart or more inside segments, times 20 mm; radians. 0 where fewer than 40
/// changes tell.
/// @param results, segments  one per piece  Cost: linear in the outlines. Pure.
double roughness(const PieceResults& results, const std::vector<OutlineSegments>& segments);

/// Rougher outlines follow wrinkles. Measured: up to 0.026 on 12 garments that were drawn or
/// simulated; from 0.039 on three of them with bumps of 5 to 7.5 mm, 28 to 80 mm wide.
inline constexpr double kWrinkledRoughness = 0.032;

/// Plans how to draw the outlines of a garment: fair, trued at the ends of seams, and mirrored. For
/// a mirrored pair the settings of the leading piece's segments apply to both; mirrored corners
/// turn, and are trued, by the mean of the two.
/// @param exact     one per piece, as solved
/// @param symmetry  null: nothing is mirrored
/// @return one per piece; null if the exact outline is to stay
/// Cost: that of `findSegments` and `planMirrors`. Pure.
std::vector<std::shared_ptr<const OutlinePlan>> planOutlines(const Garment& garment,
                                                             const PieceResults& exact,
                                                             const LineSettings& settings,
                                                             const Symmetry* symmetry);

/// Draws the line by a plan and lays it over the exact outline.
/// Errors: those of `fairOutline` and `mirroredFor`.  Cost: that of `fairOutline`. Pure.
Result<FlatLine> drawnOutline(const Piece& piece, const FlatPiece& exact, const OutlinePlan& plan,
                              const Progress& progress);

}  // namespace toile
