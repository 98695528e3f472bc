// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/mark_places.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "core/base/characters.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_grain.h"

namespace toile::app {

bool MarkPlaces::Lie::operator==(const Lie& other) const {
    return pattern.lock() == other.pattern.lock() && turn == other.turn && grain == other.grain &&
           mirrored == other.mirrored;
}

MarkPlaces::Lie MarkPlaces::lieOf(const Document& document, int piece) {
    const Placement placement = placementOf(document, piece);
    return {document.derived().pattern, placement.turn,
            grainOf(document.settings()[static_cast<std::size_t>(piece)]), placement.mirrored};
}

const PieceMarks& MarkPlaces::of(const Document& document, int piece, const DrawingWords& words) {
    static const PieceMarks kNone;
    const PatternPiece* flat = document.patternPiece(piece);
    if (!flat) {
        return kNone;
    }
    const auto at = static_cast<std::size_t>(piece);
    const std::shared_ptr<const Pattern>& pattern = document.derived().pattern;
    const PieceSettings& settings = document.settings()[at];
    const Placement placement = placementOf(document, piece);
    LabelFacts facts = factsOf(*pattern, *flat);
    facts.material = shownText(settings.material, kMaxLabelText);
    std::vector<std::string> lines =
        labelLines(nameOf(document.state().labels, *document.garment()->pieces[at]), settings,
                   placement.mirrored, words, CutAs::Whole, facts);
    entries_.resize(static_cast<std::size_t>(document.pieceCount()));
    Entry& entry = entries_[at];
    Lie lie = lieOf(document, piece);
    if (entry.lie != lie || entry.lines != lines) {
        entry.marks =
            placeMarks(*flat, placement, lines, grainOf(settings), drawnOnCloth(*pattern, *flat));
        entry.lie = std::move(lie);
        entry.lines = std::move(lines);
    }
    return entry.marks;
}

std::optional<Chord> MarkPlaces::clearGrain(const Document& document, int piece) {
    const PatternPiece* flat = document.patternPiece(piece);
    if (!flat) {
        return std::nullopt;
    }
    clears_.resize(static_cast<std::size_t>(document.pieceCount()));
    ClearGrain& clear = clears_[static_cast<std::size_t>(piece)];
    if (Lie lie = lieOf(document, piece); clear.lie != lie) {
        const Placement placement = placementOf(document, piece);
        FreeCloth cloth{{turnedLine(flat->outline, placement)}};
        for (const Points2& hole : flat->holes) {
            cloth.loops.push_back(turnedLine(hole, placement));
        }
        clear.line = grainLine(cloth, directionOnSheet(placement, lie.grain));
        clear.lie = std::move(lie);
    }
    return clear.line;
}

}  // namespace toile::app
