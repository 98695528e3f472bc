// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/shown_proof.h"

#include <utility>

namespace toile::app {

namespace {

/// The lines that cloth depends on: seam lines, and openings in them.
LineSettings linesOfCloth(LineSettings lines) {
    lines.allowance.reset();
    lines.notches.reset();
    lines.internalLines.clear();
    lines.label = {};
    for (SegmentSettings& segment : lines.segments) {
        segment.allowance.reset();
        segment.edge.reset();
        segment.corner.reset();
    }
    std::erase_if(lines.segments, [](const auto& segment) { return segment.saysNothing(); });
    return lines;
}

}  // namespace

ProofPlan proofPlanOf(const DocumentState& state) {
    ProofPlan plan = state.proof;
    if (plan.sewn == SewnPattern::Reference && !state.reference.file) {
        plan.sewn = SewnPattern::Own;
    }
    return plan;
}

ProofGround proofGround(const Derived& derived, const DocumentState& state,
                        const std::vector<PieceSettings>& settings, SewnPattern sewn) {
    ProofGround ground{derived.garment,
                       state.options,
                       state.inputs.loading,
                       linesOfCloth(state.lines),
                       state.fabric,
                       state.materials,
                       {},
                       sewn == SewnPattern::Reference ? state.reference.file : nullptr};
    ground.pieces.reserve(settings.size());
    for (const PieceSettings& piece : settings) {
        ground.pieces.push_back({0, grainOf(piece), piece.material, piece.leftOut});
    }
    return withFlat(std::move(ground), derived.results);
}

ProofGround withFlat(ProofGround ground, const PieceResults& results) {
    for (std::size_t i = 0; i < ground.pieces.size(); ++i) {
        const PieceResult* result = i < results.size() ? results[i].get() : nullptr;
        ground.pieces[i].flat = result ? result->fingerprint : 0;
    }
    return ground;
}

}  // namespace toile::app
