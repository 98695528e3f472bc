// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/layout/marker.h"
#include "core/pattern/line_settings.h"
#include "core/project/piece_settings.h"
#include "core/project/rigid_motion.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// The motion between a piece's flat coordinates and its earlier ones.
struct FlatMotion {
    RigidMotion oldOfNew{};
    std::uint64_t before = 0;  ///< fingerprint of the old points
    double radius = 0;         ///< mm: largest distance of the new points from the origin
    double residual = 0;       ///< mm: largest distance of a point due to the change of shape
};

/// Compares two flattenings, piece by piece; empty if the result is the same one, or if one of the
/// two is missing, not flat or of another piece.
/// @return one per result of `after`  Cost: linear in the vertices. Pure.
std::vector<std::optional<FlatMotion>> flatMotions(const PieceResults& before,
                                                   const PieceResults& after);

/// The settings for a new flattening: pieces stay where they are on the sheet, and the grain keeps
/// its direction on the cloth. A piece without a set turn stays upright.
/// After a cut, the largest part stays where it was in the piece. Each other part stays if it
/// overlaps nothing there, else it moves to a free place nearby; a part in a hole of the rest
/// overlaps the rest.
/// If a changed piece overlaps another one, the other makes room, or the piece itself if the user
/// placed the other. If the user placed both, both stay. With allowances, only pieces placed by the
/// user may overlap.
/// Pieces without a place go to the right of all others; if no piece has one yet, all go in rows no
/// wider than the cloth of the pieces in them (`layOutInRows`).
/// @param settings  one per result
/// @param motions   of `flatMotions`
/// @param pattern   made of the results: used for the cut size of pieces; null: their outlines
/// @param own       the garment's fabric, for pieces without a material
/// Cost: linear in the outlines, some milliseconds more for each piece that moves. Pure.
std::vector<PieceSettings> placedSettings(std::vector<PieceSettings> settings,
                                          const PieceResults& results,
                                          const std::vector<std::optional<FlatMotion>>& motions,
                                          const Pattern* pattern = nullptr,
                                          const MaterialList& materials = {},
                                          const Fabric& own = fabricPresets().front());

/// Sets the grain by the rule (`findGrains`) on each piece without a grain of its own.
/// @param settings  one per result  @param symmetry  null: every piece is treated alone
/// @param own  the garment's fabric, for pieces without a material
void setGrains(std::vector<PieceSettings>& settings, const Garment& garment,
               const PieceResults& results, const Symmetry* symmetry, GrainRule rule,
               const MaterialList& materials, const Fabric& own);

/// The pattern cut and laid out by the settings of its pieces.
/// @param settings  one per piece, or empty  Cost: linear. Pure.
LaidOutPattern cutAndPlace(Pattern pattern, const std::vector<PieceSettings>& settings,
                           MaterialList materials, const Fabric& own);

}  // namespace toile
