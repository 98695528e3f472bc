// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

// Internal header of this folder.
namespace toile {

class EndingWorkers;

/// True if the settings draw lines differently from how they are solved.
inline bool draws(const LineSettings& settings) {
    const auto isTyped = [](const DartSettings& stated) { return stated.intake.has_value(); };
    return settings.fairing || settings.mirror != Mirror::None ||
           std::ranges::any_of(settings.darts, isTyped);
}

/// Approximate share of the time spent solving, before lines are drawn.
inline double solvingShare(const LineSettings& settings) {
    return draws(settings) ? 0.7 : 1;
}

/// Draws the outlines by the settings: fair, trued at the ends of seams, straight, mirrored; then
/// solves the interior again inside them. Pieces run in parallel. A piece whose outline cannot be
/// drawn keeps the exact one, with a note.
/// @param exact     one per piece
/// @param symmetry  null: nothing is mirrored
/// @param known     earlier drawn results: one with the same result and plan is reused
/// @param ending    as in `workOn`
/// @return one per piece; `exact` if there is nothing to draw
PieceResults drawLines(const Garment& garment, PieceResults exact, const LineSettings& settings,
                       const Symmetry* symmetry, const PieceResults& known, Progress& progress,
                       int threads, EndingWorkers* ending = nullptr);

}  // namespace toile
