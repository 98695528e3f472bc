// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/pattern_faults.h"

#include <algorithm>
#include <cmath>

#include "core/prove/proof_words.h"
#include "core/prove/stations.h"
#include "core/seam/seam_measure.h"

namespace toile::prove {
namespace {

constexpr double kOtherLength = 5, kOtherShare = 0.03;  // mm, and of the length

double sideLength(const SeamSide& side, const RestPattern& pattern) {
    const auto [low, high] = std::minmax(side.start, side.end);
    return loopOf(side, pattern).restLength(low, high);
}

}  // namespace

SeamLengths seamLengths(const Garment& garment, const RestPattern& pattern) {
    SeamLengths found;
    const std::vector<Seam>& seams = garment.seams.seams;
    for (int k = 0; k < static_cast<int>(seams.size()); ++k) {
        const Seam& seam = seams[k];
        if (!isSewn(seam, pattern)) {
            continue;
        }
        const double left = sideLength(seam.left, pattern);
        const double right = sideLength(seam.right, pattern);
        const double slip = left - (1 + easeOf(seam)) * right;
        found.seams.push_back({k, left, right, slip, 0});
        if (std::abs(slip) > kNearlyMm) {
            found.faults.push_back(seamSlips(garment, k, slip));
        }
        const double byLeft = left - seam.length3d[0], byRight = right - seam.length3d[1];
        const double least = std::abs(byLeft) < std::abs(byRight) ? byLeft : byRight;
        const double whole = std::max(seam.length3d[0], seam.length3d[1]);
        if (byLeft * byRight > 0 && std::abs(least) > std::max(kOtherLength, kOtherShare * whole)) {
            found.faults.push_back(seamLengthDiffers(garment, k, least));
        }
    }
    return found;
}

namespace {

/// Sewn length of a stretch of outline, mm: each of its edges by its share.
double sewnLength(const SeamSide& side, const Piece& piece, const Points3& sewn) {
    const std::vector<int>& loop = loopOf(side, piece);
    const double from = std::min(side.start, side.end), to = std::max(side.start, side.end);
    double length = 0, at = 0;
    for (std::size_t k = 0; k < 2 * loop.size() && at < to; ++k) {  // it may pass the last vertex
        const int v = loop[k % loop.size()], w = loop[(k + 1) % loop.size()];
        const double edge = (piece.mesh.V.row(w) - piece.mesh.V.row(v)).norm();
        const double taken = std::min(to, at + edge) - std::max(from, at);
        if (taken > 0) {
            length += taken / edge * (sewn.row(w) - sewn.row(v)).norm();
        }
        at += edge;
    }
    return length;
}

}  // namespace

double seamStrain(const Garment& garment, const ProvenSeam& seam,
                  const std::vector<ProvenPiece>& pieces) {
    const Seam& sewn = garment.seams.seams[static_cast<std::size_t>(seam.seam)];
    double sum = 0;
    int count = 0;
    const auto take = [&](const SeamSide& side, double rest) {
        const auto number = static_cast<std::size_t>(side.piece);
        if (side.piece >= 0 && rest > 0 && pieces[number].isSewn()) {
            sum += sewnLength(side, *garment.pieces[number], pieces[number].sewn) / rest - 1;
            ++count;
        }
    };
    take(sewn.left, seam.left);
    take(sewn.right, seam.right);
    return count > 0 ? sum / count : 0;
}

}  // namespace toile::prove
