// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/mark_places.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "core/pattern/pattern.h"

namespace toile {

const PieceMarks& MarkPlaces::of(const Document& document, int piece, const DrawingWords& words) {
    static const PieceMarks kNone;
    const auto at = static_cast<std::size_t>(piece);
    if (const PieceResult* result = document.result(piece); !result || !result->flat) {
        return kNone;
    }
    const PieceSettings& settings = document.settings()[at];
    const Placement placement = placementOf(document, piece);
    PatternPiece drawn;
    drawn.name = document.garment()->pieces[at]->name;
    drawn.quantity = settings.quantity;
    drawn.mirroredPair = settings.mirroredPair;
    drawn.mirrored = placement.mirrored;
    std::vector<std::string> lines = labelLines(drawn, words);
    const double grain = directionOnSheet(placement, grainOf(settings));
    const auto& result = document.results()[at];
    entries_.resize(static_cast<std::size_t>(document.pieceCount()));
    Entry& entry = entries_[at];
    if (entry.result.lock() != result || entry.turn != placement.turn || entry.grain != grain ||
        entry.mirrored != placement.mirrored || entry.lines != lines) {
        std::vector<Points2> loops = flatLoops(*result->piece, result->flat->Q);
        for (Points2& loop : loops) {
            loop = (loop * placement.linear().transpose()).eval();
        }
        entry.marks = placeMarks(loops, lines, grain);
        entry.result = result;
        entry.turn = placement.turn;
        entry.grain = grain;
        entry.mirrored = placement.mirrored;
        entry.lines = std::move(lines);
    }
    return entry.marks;
}

}  // namespace toile
