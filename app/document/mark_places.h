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

/// Where the labels and grain lines of the document's pieces go, as a file has them (`placeMarks`).
/// Keeps what it has found for as long as pattern, turn, grain and words are the same: to look for
/// room costs some hundred passes over the outline.
class MarkPlaces {
public:
    /// About the piece's offset on the sheet; the grain line is there whether anybody has stated
    /// the grain or not. Valid until the next call.
    const PieceMarks& of(const Document& document, int piece, const DrawingWords& words);
    /// Where a grain line has most room on a piece if nothing else is drawn there, about its
    /// offset; none where the piece is not flat or there is no room.
    std::optional<Chord> clearGrain(const Document& document, int piece);

private:
    /// What all of them follow from.
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
