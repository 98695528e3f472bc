// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <set>
#include <utility>

#include "core/base/text.h"
#include "core/base/unique_names.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/seam/seam_measure.h"

namespace toile {

namespace {

void addSide(PatternPiece& made, const Piece& piece, const FlatPiece& flat, const Seam& seam,
             int number, const SeamSide& side) {
    Points2 line = flatLine(side, piece, flat);
    if (side.reversed) {
        line = line.colwise().reverse().eval();
    }
    made.seams.push_back({number, seam.name, std::move(line), seam.closed, seam.kind,
                          &side == &seam.right, seam.id});
}

void addSeams(PatternPiece& made, const Piece& piece, const FlatPiece& flat, const SeamGraph& graph,
              int index) {
    std::set<int> touched;
    if (index < static_cast<int>(graph.seamsOfEdge.size())) {
        for (const std::vector<int>& ofEdge : graph.seamsOfEdge[index]) {
            touched.insert(ofEdge.begin(), ofEdge.end());
        }
    }
    if (index < static_cast<int>(graph.seamsOfHoles.size())) {
        touched.insert(graph.seamsOfHoles[index].begin(), graph.seamsOfHoles[index].end());
    }
    for (const int k : touched) {
        const Seam& seam = graph.seams[k];
        for (const SeamSide* side : {&seam.left, &seam.right}) {
            if (side->piece == index) {
                addSide(made, piece, flat, seam, k + 1, *side);
            }
        }
    }
}

}  // namespace

Pattern makePattern(const Garment& garment, const PieceResults& results) {
    Pattern pattern;
    pattern.name =
        garment.files.empty() ? std::string() : garment.files.front()->path.stem().string();
    pattern.pieces.resize(garment.pieces.size());
    UniqueNames slugs;
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        PatternPiece& made = pattern.pieces[i];
        made.name = garment.pieces[i]->name;
        made.id = garment.pieces[i]->id;
        if (i >= results.size() || !results[i] || !results[i]->flat) {
            continue;
        }
        const Piece& piece = *results[i]->piece;
        const FlatPiece& flat = *results[i]->flat;
        made.slug = slugs.free(slug(made.name), "-");
        made.holes = flatLoops(piece, flat);
        made.outline = std::move(made.holes.front());
        made.holes.erase(made.holes.begin());
        addSeams(made, piece, flat, garment.seams, static_cast<int>(i));
    }
    return pattern;
}

std::vector<Points2> flatLoops(const Piece& piece, const FlatPiece& flat) {
    std::vector<Points2> loops{flat.line ? flat.line->points
                                         : Points2(flat.Q(piece.boundary, Eigen::all))};
    for (const auto& hole : piece.holes) {
        loops.emplace_back(flat.Q(hole, Eigen::all));
    }
    return loops;
}

}  // namespace toile
