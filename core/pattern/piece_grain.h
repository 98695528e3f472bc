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

/// The direction of the warp on every piece, radians in flat coordinates, with "up" defined by the
/// rule. If two pieces mirror each other, the second gets the mirrored direction of the first. On a
/// piece that mirrors itself the grain runs exactly along its axis, the fold of its half pattern,
/// or at 90 degrees to it, whichever is nearer; a reference panel may also lie on its bias.
/// @param results   one per piece
/// @param symmetry  null: every piece is treated alone
/// @param fabrics   one per piece, for LeastStrain; an unset fabric counts as woven
/// @return nothing if a piece is not flat, or lies level, so that no direction is up
/// Cost: linear in the triangles. Pure.
std::vector<std::optional<double>> findGrains(const Garment& garment, const PieceResults& results,
                                              const Symmetry* symmetry, GrainRule rule,
                                              const std::vector<Fabric>& fabrics);

}  // namespace toile
