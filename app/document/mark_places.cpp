// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/mark_places.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "core/base/characters.h"
#include "core/pattern/pattern.h"

namespace toile::app {

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
    const double grain = grainOf(settings);
    entries_.resize(static_cast<std::size_t>(document.pieceCount()));
    Entry& entry = entries_[at];
    if (entry.pattern.lock() != pattern || entry.turn != placement.turn || entry.grain != grain ||
        entry.mirrored != placement.mirrored || entry.lines != lines) {
        entry.marks = placeMarks(*flat, placement, lines, grain, drawnOnCloth(*pattern, *flat));
        entry.pattern = pattern;
        entry.turn = placement.turn;
        entry.grain = grain;
        entry.mirrored = placement.mirrored;
        entry.lines = std::move(lines);
    }
    return entry.marks;
}

}  // namespace toile::app
