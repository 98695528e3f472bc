// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/moved_garment.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/seam/outline.h"

namespace toile {
namespace {

/// Ratios that differ by less are equal.
constexpr double kSameRatio = 1e-12;

bool hasBothSides(const Seam& seam) {
    return seam.left.piece >= 0 && seam.right.piece >= 0;
}

void moveSeam(Seam& seam, const seam::Outlines& before, const seam::Outlines& after) {
    const auto moved = [&](const SeamSide& side, double s) {
        const int outline = before.indexOf(side);
        return before.list[outline].length() > 0
                   ? before.list[outline].line.placeOn(after.list[outline].line, s)
                   : s;
    };
    for (SeamMatch& match : seam.matches) {
        match = {moved(seam.left, match.left), moved(seam.right, match.right)};
    }
    const double ratio =
        hasBothSides(seam) ? seam.left.length() / seam.right.length() : 1;  // as designed
    for (SeamSide* side : {&seam.left, &seam.right}) {
        if (side->piece >= 0) {
            std::tie(side->start, side->end) =
                std::pair(moved(*side, side->start), moved(*side, side->end));
            seam.length3d[side == &seam.left ? 0 : 1] = side->length();
        }
    }
    const bool isAnothersPlace = !hasBothSides(seam) || seam.stacked || seam.kind == SeamKind::Free;
    if (isAnothersPlace || (seam.ease && seam.drawn) || !std::isfinite(ratio)) {
        return;
    }
    const double right = ratio * seam.right.length();
    if (std::abs(seam.left.length() - right) > kSameRatio * right) {
        seam.ease = ratio - 1;
        seam.drawn = SeamPart{};
    }
}

}  // namespace

Garment movedGarment(const Garment& garment, const std::vector<Points3>& positions) {
    Garment moved = garment;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        if (positions[p].rows() > 0) {
            auto piece = std::make_shared<Piece>(*garment.pieces[p]);
            piece->mesh.V = positions[p];
            moved.pieces[p] = std::move(piece);
        }
    }
    const seam::Outlines before = seam::buildOutlines(garment.pieces);
    const seam::Outlines after = seam::buildOutlines(moved.pieces);
    for (Seam& seam : moved.seams.seams) {
        moveSeam(seam, before, after);
    }
    return moved;
}

}  // namespace toile
