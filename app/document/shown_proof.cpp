// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/shown_proof.h"

#include <utility>

namespace toile::app {

namespace {

/// What of the lines cloth depends on: seam lines, and openings in them.
LineSettings linesOfCloth(LineSettings lines) {
    lines.allowance.reset();
    lines.notches.reset();
    lines.internalLines.clear();
    lines.label = {};
    for (SegmentSettings& segment : lines.segments) {
        segment.allowance.reset();
        segment.corner.reset();
    }
    std::erase_if(lines.segments, [](const auto& segment) { return segment.saysNothing(); });
    return lines;
}

}  // namespace

ProofGround proofGround(const Derived& derived, const DocumentState& state,
                        const std::vector<PieceSettings>& settings, SewnPattern sewn) {
    ProofGround ground{derived.garment,
                       derived.results,
                       state.inputs.loading,
                       linesOfCloth(state.lines),
                       state.fabric,
                       state.materials,
                       {},
                       sewn == SewnPattern::Reference ? state.reference.file : nullptr};
    ground.pieces.reserve(settings.size());
    for (const PieceSettings& piece : settings) {
        ground.pieces.push_back({grainOf(piece), piece.material, piece.leftOut});
    }
    return ground;
}

}  // namespace toile::app
