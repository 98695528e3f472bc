// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_measure.h"

#include <algorithm>

namespace toile {

double flatLength(const SeamSide& side, const Piece& piece, const Points2& Q) {
    const int n = static_cast<int>(piece.boundary.size());
    const auto [low, high] = std::minmax(side.start, side.end);
    // The arc length at which edge `first` begins, summed up as when the seam was found.
    double arc = 0;
    for (int k = 0; k < side.first; ++k) {
        arc += (piece.mesh.V.row(piece.boundary[k + 1 < n ? k + 1 : 0]) -
                piece.mesh.V.row(piece.boundary[k]))
                   .norm();
    }
    double flat = 0;
    for (int k = side.first; k < side.first + side.count; ++k) {
        const int u = piece.boundary[k % n], v = piece.boundary[(k + 1) % n];
        const double length = (piece.mesh.V.row(v) - piece.mesh.V.row(u)).norm();
        const double part = std::min(high, arc + length) - std::max(low, arc);
        // A whole edge is taken whole, free of the rounding in the sums.
        const double share = part > (1 - 1e-9) * length ? 1 : std::max(0.0, part / length);
        flat += share * (Q.row(v) - Q.row(u)).norm();
        arc += length;
    }
    return flat;
}

SeamMeasure measureSeam(const Seam& seam, const Piece& l, const Points2& Ql, const Piece& r,
                        const Points2& Qr, std::optional<double> ease) {
    SeamMeasure measure;
    measure.length3d[0] = seam.length3d[0];
    measure.length3d[1] = seam.length3d[1];
    measure.length2dLeft = flatLength(seam.left, l, Ql);
    if (seam.right.piece < 0) {
        return measure;
    }
    measure.length2dRight = flatLength(seam.right, r, Qr);
    measure.deltaMm = measure.length2dLeft - measure.length2dRight;
    measure.ease = ease.value_or(seam.length3d[0] / seam.length3d[1] - 1);
    measure.errorMm = measure.length2dLeft - (1 + measure.ease) * measure.length2dRight;
    return measure;
}

}  // namespace toile
