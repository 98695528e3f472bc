// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/json.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// The report's `symmetry`: the plane, what mirrors what, and what common lengths change.
/// @param results  one per piece  Cost: pieces and seams. Pure.
Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry);

}  // namespace toile
