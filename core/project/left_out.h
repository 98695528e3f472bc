// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// The results with excluded pieces marked as not flat (`isLeftOut`), so that they are in no
/// pattern, file or figure. A piece that is included again is null if it has no other result.
/// @param results   one per piece of the garment, null if there is none
/// @param settings  one per piece, or empty  Cost: negligible. Pure.
PieceResults withoutLeftOut(PieceResults results, const Garment& garment,
                            const std::vector<PieceSettings>& settings);

/// The area of a piece in 3D, mm2, by which small parts such as buttons are recognised.
double wornArea(const Piece& piece);

}  // namespace toile
