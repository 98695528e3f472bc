// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <map>
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
    std::map<std::string, int> nextNumber;  // thousands of pieces may share a name
    for (PatternPiece& piece : pattern.pieces) {
        const std::string base = piece.id;
        int& next = nextNumber.try_emplace(base, 2).first->second;
        while (!taken.insert(piece.id).second) {
            piece.id = base + "-" + std::to_string(next++);
        }
    }
}

}  // namespace toile
