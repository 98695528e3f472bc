// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/same_piece.h"

namespace toile {

bool isSamePiece(const Piece& a, const Piece& b) {
    const auto same = [](const auto& one, const auto& other) -> bool {
        return one.rows() == other.rows() && one == other;
    };
    const bool sameReference = a.reference.has_value() == b.reference.has_value() &&
                               (!a.reference || same(*a.reference, *b.reference));
    const bool sameDefect =
        a.defect.has_value() == b.defect.has_value() &&
        (!a.defect || (a.defect->code == b.defect->code && a.defect->detail == b.defect->detail));
    return a.name == b.name && a.file == b.file && same(a.mesh.F, b.mesh.F) &&
           same(a.mesh.V, b.mesh.V) && a.sourceVertex == b.sourceVertex &&
           a.sourceFace == b.sourceFace && a.boundary == b.boundary && a.holes == b.holes &&
           sameReference && sameDefect;
}

}  // namespace toile
