// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/layout/placement.h"
#include "core/layout/sheet.h"
#include "core/pattern/pattern.h"

namespace toile {

/// The piece turned and mirrored as it lies on the sheet; the offset is left out, so that it lies
/// around the same place as before. Mirrored outlines, holes and seams run the other way round, as
/// a PatternPiece promises. A piece that is not turned keeps every digit. Cost: linear. Pure.
PatternPiece turnedPiece(PatternPiece piece, const Placement& placement);

/// Turns and mirrors each piece of the pattern as it is to lie, notes its grain and how often it is
/// cut, and returns where the pieces go:
/// the sheet that holds them all, its lower left corner at (0, 0). Those without a place lie in
/// rows to the right of the others; with no places at all the sheet is that of `layOutInRows`.
/// @param places  one per piece of the pattern, or none
Sheet placeOnSheet(Pattern& pattern, const std::vector<PieceOnSheet>& places);

}  // namespace toile
