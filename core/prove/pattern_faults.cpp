// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/pattern_faults.h"

#include <algorithm>
#include <cmath>

#include "core/prove/fault_words.h"
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

}  // namespace toile::prove
