// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/reuse_pieces.h"

#include <algorithm>
#include <map>

namespace toile {
namespace {

/// Whether all members of a piece are unchanged.
bool isAsBefore(const Piece& now, const Piece& before) {
    const auto same = [](const auto& a, const auto& b) -> bool {
        return a.rows() == b.rows() && a == b;
    };
    return now.name == before.name && now.file == before.file &&
           now.sourceVertex == before.sourceVertex && now.sourceFace == before.sourceFace &&
           same(now.mesh.F, before.mesh.F) && same(now.mesh.V, before.mesh.V) &&
           now.reference.has_value() == before.reference.has_value() &&
           (!now.reference || same(*now.reference, *before.reference));
}

}  // namespace

void reusePieces(Pieces& pieces, const Garment& before) {
    std::map<PieceId, Pieces> known;
    const auto know = [&known](const std::shared_ptr<const Piece>& piece) {
        known[piece->id].push_back(piece);
    };
    std::ranges::for_each(before.uncut, know);
    std::ranges::for_each(before.pieces, know);
    for (const CutRecord& cut : before.cutRecords) {
        know(cut.whole);
    }
    for (auto& piece : pieces) {
        for (const auto& old : known[piece->id]) {
            if (piece == old || isAsBefore(*piece, *old)) {
                piece = old;
                break;
            }
        }
    }
}

}  // namespace toile
