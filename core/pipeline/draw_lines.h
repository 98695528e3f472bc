// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

// For the sources of this folder only.
namespace toile {

/// True where lines are drawn otherwise than they are solved.
inline bool draws(const LineSettings& settings) {
    const auto isTyped = [](const DartSettings& said) { return said.intake.has_value(); };
    return settings.fairing || settings.mirror != Mirror::None ||
           std::ranges::any_of(settings.darts, isTyped);
}

/// Of the time, about, until all is flat that is then drawn.
inline double solvingShare(const LineSettings& settings) {
    return draws(settings) ? 0.7 : 1;
}

/// The results with their outlines drawn as a person has said: fair, trued where they meet at the
/// ends of seams, straight where asked for, mirrored, and the interior solved anew inside them.
/// Pieces side by side; one whose outline cannot be drawn keeps the exact one and a note.
/// @param exact     one per piece
/// @param symmetry  null: nothing is mirrored
/// @param known     drawn before: what is of the same result and plan is handed on
/// @return one per piece; `exact` where nothing is to be drawn
PieceResults drawLines(const Garment& garment, PieceResults exact, const LineSettings& settings,
                       const Symmetry* symmetry, const PieceResults& known, Progress& progress,
                       int threads);

}  // namespace toile
