// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// The direction of the warp on every piece, radians in flat coordinates, upwards in the sense of
/// the rule. Of two pieces that mirror each other the first one's holds for both, mirrored. On a
/// piece that mirrors itself it runs exactly along its axis, the fold of its half pattern, or at
/// 90 degrees to it, whichever is nearer; a reference panel may lie on the bias of the axis too.
/// @param results   one per piece
/// @param symmetry  null: every piece is looked at alone
/// @param fabrics   one per piece, for LeastStrain; one that is not stated counts as woven
/// @return none where a piece is not flat, or lies level, so that no way is up
/// Cost: linear in the triangles. Pure.
std::vector<std::optional<double>> findGrains(const Garment& garment, const PieceResults& results,
                                              const Symmetry* symmetry, GrainRule rule,
                                              const std::vector<Fabric>& fabrics);

}  // namespace toile
