// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/pattern/piece_marks.h"
#include "core/project/piece_settings.h"

namespace toile::app {

class Document;

/// Where the labels and grain lines of the document's pieces are drawn, as in files (`placeMarks`).
/// Results are kept while pattern, rotation, grain and text are the same, because each search takes
/// some hundred passes over the outline.
class MarkPlaces {
public:
    /// Relative to the piece's offset on the sheet; with a grain line even if no grain is stated.
    /// Valid until the next call.
    const PieceMarks& of(const Document& document, int piece, const DrawingWords& words);
    /// The place with most room for a grain line if nothing else is drawn, relative to the piece's
    /// offset; none if the piece is not flat or there is no room.
    std::optional<Chord> clearGrain(const Document& document, int piece);

private:
    /// The inputs of all places.
    struct Lie {
        std::weak_ptr<const Pattern> pattern;
        double turn = 0, grain = 0;
        bool mirrored = false;

        bool operator==(const Lie& other) const;
    };

    struct Entry {
        Lie lie;
        std::vector<std::string> lines;
        PieceMarks marks;
    };

    struct ClearGrain {
        Lie lie;
        std::optional<Chord> line;
    };

    static Lie lieOf(const Document& document, int piece);

    std::vector<Entry> entries_;      ///< one per piece
    std::vector<ClearGrain> clears_;  ///< one per piece
};

}  // namespace toile::app
