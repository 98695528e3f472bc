// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/layout/marker.h"
#include "core/project/piece_settings.h"
#include "core/project/rigid_motion.h"

namespace toile {

/// How a piece's flat coordinates differ from those it had before.
struct FlatMotion {
    RigidMotion oldOfNew{};
    std::uint64_t before = 0;  ///< the old points' fingerprint
    double radius = 0;         ///< mm: how far from the origin the new points go
    double residual = 0;       ///< mm: how far a point gets at most by the change of shape
};

/// Compares two flattenings, piece by piece; none where the result is the same one, or one of the
/// two is not there, not flat or of another piece.
/// @return one per result of `after`  Cost: linear in the vertices. Pure.
std::vector<std::optional<FlatMotion>> flatMotions(const PieceResults& before,
                                                   const PieceResults& after);

/// The settings for a new flattening: pieces stay where they are on the sheet, and the grain keeps
/// its direction on the cloth. A piece whose turn is unset stays upright.
/// Of the parts of one piece that was cut the largest stays where it was in the piece. The others
/// do so too where they lie on nothing there, else they go to a free place nearby; what lies in a
/// hole of the rest lies on the rest.
/// Where a piece has another shape and lies on another one now, that one makes room, or the piece
/// itself does, if its place is unset; where both were, both stay. With allowances no two pieces
/// lie on each other but those that a person has placed.
/// Pieces without a place get one: to the right of all others; or, where no piece has one yet,
/// all in rows, none wider than a cloth which the pieces in it are cut from (`layOutInRows`).
/// @param settings  one per result
/// @param motions   of `flatMotions`
/// @param pattern   made of the results: pieces are as large as they are cut; null: as their
///                  outlines
/// @param own       the garment's fabric: of pieces without a material
/// Cost: linear in the outlines, some milliseconds more for each piece that has to move. Pure.
std::vector<PieceSettings> placedSettings(std::vector<PieceSettings> settings,
                                          const PieceResults& results,
                                          const std::vector<std::optional<FlatMotion>>& motions,
                                          const Pattern* pattern = nullptr,
                                          const MaterialList& materials = {},
                                          const Fabric& own = fabricPresets().front());

/// The pattern as it is cut and laid out, as has been said of its pieces.
/// @param settings  one per piece, or none  Cost: linear. Pure.
LaidOutPattern laidOutAs(Pattern pattern, const std::vector<PieceSettings>& settings,
                         const MaterialList& materials);

/// The pattern as a person has it: called, cut and laid out as has been said.
/// @param settings  one per piece, or none  @param lines, symmetry  as of `makePattern`
/// Cost: that of `makePattern`. Pure.
LaidOutPattern layOut(const Garment& garment, const PieceResults& results,
                      const std::vector<PieceSettings>& settings, const PieceLabels& labels,
                      const LineSettings& lines = {},
                      std::shared_ptr<const Symmetry> symmetry = {});

}  // namespace toile
