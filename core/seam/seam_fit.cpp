// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_fit.h"

#include <cmath>

namespace toile {

std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam) {
    const Seam& asked = garment.seams.seams[static_cast<std::size_t>(seam)];
    const auto result = [&results](const SeamSide& side) -> const PieceResult* {
        const auto at = static_cast<std::size_t>(side.piece);
        return at < results.size() ? results[at].get() : nullptr;
    };
    const PieceResult* left = result(asked.left);
    const PieceResult* right = asked.right.piece < 0 ? left : result(asked.right);
    if (!left || !right || !left->flat || !right->flat) {
        return std::nullopt;
    }
    return measureSeam(asked, *left->piece, left->flat->Q, *right->piece, right->flat->Q);
}

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure) {
    if (!measure || seam.kind == SeamKind::Free) {
        return SeamFit::Unknown;
    }
    const double error = std::abs(measure->errorMm);
    return error <= kMatchesMm  ? SeamFit::Matches
           : error <= kNearlyMm ? SeamFit::Nearly
                                : SeamFit::Differs;
}

}  // namespace toile
