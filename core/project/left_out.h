// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// The results as a person wants them: pieces that are left out are not flat (`isLeftOut`), and so
/// in no pattern, file or figure. What is no more left out is null where it has no other result.
/// @param results   one per piece of the garment, null where there is none
/// @param settings  one per piece, or none  Cost: none to speak of. Pure.
PieceResults withoutLeftOut(PieceResults results, const Garment& garment,
                            const std::vector<PieceSettings>& settings);

/// The area of a piece as it is worn, mm2: by it small parts, such as buttons, are known.
double wornArea(const Piece& piece);

}  // namespace toile
