// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/words.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// By what the direction of the warp is found.
enum class GrainRule {
    /// As the garment hangs: up its height, on the mean over the piece. Where that cancels out, as
    /// on a sleeve held out sideways, along the tube if the piece is sewn to itself, else the way
    /// that height changes most.
    Vertical,
    /// Up the reference panel, as the designer laid it; Vertical where the piece has none.
    Reference,
    /// Vertical, or at 90 or 45 degrees to it where the cloth then suffers less by a fifth; no odd
    /// angles, which no pattern maker would cut at.
    LeastStrain,
};

inline constexpr Word<GrainRule> kGrainRuleWords[] = {{GrainRule::Vertical, "vertical"},
                                                      {GrainRule::Reference, "reference"},
                                                      {GrainRule::LeastStrain, "least-strain"}};

/// The direction of the warp on every piece, radians in flat coordinates, upwards in the sense of
/// the rule. Of two pieces that mirror each other the first one's holds for both, mirrored.
/// @param results   one per piece
/// @param symmetry  null: every piece is looked at alone
/// @param fabric    for LeastStrain
/// @return none where a piece is not flat, or lies level, so that no way is up
/// Cost: linear in the triangles. Pure.
std::vector<std::optional<double>> findGrains(const Garment& garment, const PieceResults& results,
                                              const Symmetry* symmetry, GrainRule rule,
                                              const Fabric& fabric);

}  // namespace toile
