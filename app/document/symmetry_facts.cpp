// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/symmetry_facts.h"

#include <algorithm>

#include "app/document/line_facts.h"
#include "core/pattern/fair_outline.h"

namespace toile::app {

namespace {

const PieceResult* flatResult(const PieceResults& results, int piece) {
    const auto at = static_cast<std::size_t>(piece);
    const PieceResult* result = at < results.size() ? results[at].get() : nullptr;
    return result && result->flat ? result : nullptr;
}

MirroredPieces rowOf(const PieceResults& results, const Symmetry& symmetry, int piece) {
    const MirrorPieces& pieces = symmetry.pieces;
    using Drawing = MirroredPieces::Drawing;
    const auto at = static_cast<std::size_t>(piece);
    MirroredPieces row{piece, pieces.counterpart[at], pieces.deviation[at]};
    const PieceResult* result = flatResult(results, piece);
    const auto unequal = std::ranges::find_if(symmetry.unequal, [&row](const UnequalPieces& one) {
        return row.counterpart >= 0 && (one.piece == row.piece || one.counterpart == row.piece);
    });
    if (unequal != symmetry.unequal.end()) {
        row.unequal = *unequal;
    }
    if (!result || (row.isPair() && !flatResult(results, row.counterpart))) {
        row.drawing = Drawing::NotFlat;
    } else if (result->plan && result->plan->mirrored) {
        row.drawing = result->flat->line ? Drawing::Equal : Drawing::NotDrawn;
        row.lead = result->plan->mirrored->isImage ? row.counterpart : piece;
    } else if (row.unequal && !symmetry.kept.empty()) {
        row.drawing = Drawing::Kept;
    }
    return row;
}

/// Pairs come first, pieces without a counterpart last.
int rankOf(const MirroredPieces& row) {
    return row.isPair() ? 0 : row.counterpart >= 0 ? 1 : 2;
}

}  // namespace

SymmetryFacts symmetryFacts(const Garment& garment, const PieceResults& results,
                            const Symmetry& symmetry) {
    SymmetryFacts facts;
    for (int piece = 0; piece < static_cast<int>(garment.pieces.size()); ++piece) {
        const int other = symmetry.pieces.counterpart[static_cast<std::size_t>(piece)];
        if (other < 0 || other >= piece) {
            facts.rows.push_back(rowOf(results, symmetry, piece));
        }
    }
    std::ranges::stable_sort(facts.rows, {}, rankOf);
    for (const MirroredPieces& row : facts.rows) {
        facts.pairs += row.counterpart >= 0 ? 1 : 0;
        facts.equal += row.drawing == MirroredPieces::Drawing::Equal ? 1 : 0;
    }
    facts.seams = symmetry.lengths.withoutCounterpart();
    facts.lengthChange = largestChange(garment.seams, symmetry.lengths);
    const DrawnFacts drawn = drawnFacts(garment, results);
    facts.exactStrain = drawn.exactStrain;
    facts.strain = drawn.strain;
    return facts;
}

}  // namespace toile::app
