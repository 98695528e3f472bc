// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
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

private:
    struct Entry {
        std::weak_ptr<const Pattern> pattern;
        double turn = 0, grain = 0;
        bool mirrored = false;
        std::vector<std::string> lines;
        PieceMarks marks;
    };

    std::vector<Entry> entries_;  ///< one per piece
};

}  // namespace toile::app
