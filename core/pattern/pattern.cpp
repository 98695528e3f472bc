// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <set>

#include "core/base/text.h"
#include "core/flatten/flatten.h"
#include "core/garment/garment.h"

namespace toile {

PatternPiece makePatternPiece(const Piece& piece, const FlatPiece& flat) {
    PatternPiece made;
    made.name = piece.name;
    made.id = slug(piece.name);
    made.outline = flat.Q(piece.boundary, Eigen::all);
    return made;
}

void makeIdsUnique(Pattern& pattern) {
    std::set<std::string> taken;
    for (PatternPiece& piece : pattern.pieces) {
        const std::string base = piece.id;
        for (int k = 2; !taken.insert(piece.id).second; ++k) {
            piece.id = base + "-" + std::to_string(k);
        }
    }
}

}  // namespace toile
