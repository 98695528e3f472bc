// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/base/unique_names.h"
#include "core/flatten/flatten.h"
#include "core/garment/garment.h"
#include "core/seam/seam_measure.h"

namespace toile {

namespace {

void addMark(PatternPiece& made, const Piece& piece, const FlatPiece& flat, const Seam& seam,
             int number, const SeamSide& side) {
    Points2 line = flatLine(side, piece, flat.Q);
    if (side.reversed) {
        line = line.colwise().reverse().eval();
    }
    made.seams.push_back({number, seam.name, std::move(line), seam.closed});
}

}  // namespace

PatternPiece makePatternPiece(const Piece& piece, const FlatPiece& flat, const SeamGraph& seams,
                              int index) {
    PatternPiece made;
    made.name = piece.name;
    made.id = slug(piece.name);
    made.holes = flatLoops(piece, flat.Q);
    made.outline = std::move(made.holes.front());
    made.holes.erase(made.holes.begin());
    std::set<int> touched;
    if (index < static_cast<int>(seams.seamsOfEdge.size())) {
        for (const std::vector<int>& ofEdge : seams.seamsOfEdge[index]) {
            touched.insert(ofEdge.begin(), ofEdge.end());
        }
    }
    if (index < static_cast<int>(seams.seamsOfHoles.size())) {
        touched.insert(seams.seamsOfHoles[index].begin(), seams.seamsOfHoles[index].end());
    }
    for (const int k : touched) {
        const Seam& seam = seams.seams[k];
        for (const SeamSide& side : {seam.left, seam.right}) {
            if (seam.kind != SeamKind::Free && side.piece == index) {
                addMark(made, piece, flat, seam, k + 1, side);
            }
        }
    }
    return made;
}

std::vector<Points2> flatLoops(const Piece& piece, const Points2& Q) {
    std::vector<Points2> loops{Q(piece.boundary, Eigen::all)};
    for (const auto& hole : piece.holes) {
        loops.emplace_back(Q(hole, Eigen::all));
    }
    return loops;
}

void makeIdsUnique(Pattern& pattern) {
    UniqueNames names;
    for (PatternPiece& piece : pattern.pieces) {
        piece.id = names.free(piece.id, "-");
    }
}

}  // namespace toile
