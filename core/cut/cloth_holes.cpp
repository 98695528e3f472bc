// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cloth_holes.h"

#include <algorithm>
#include <numbers>

namespace toile {
namespace {

/// Three quarters of a turn: what a flat piece must turn by at least.
constexpr double kNearlyATurn = 1.5 * std::numbers::pi;

/// By how much the rim turns to the side of the cloth, radians: a disk's outline by 2 pi.
double turning(const SurfaceLinks& links, const RimLoop& loop) {
    double sum = 0;
    for (const int v : loop.vertices) {
        sum += std::numbers::pi - links.angleAround(v);
    }
    return sum;
}

}  // namespace

SortedLoops sortLoops(const SurfaceLinks& links, double smallHole) {
    SortedLoops sorted;
    std::vector<RimLoop> loops = rimLoops(links);
    if (loops.empty()) {
        return sorted;
    }
    const auto longest = std::ranges::max_element(loops, {}, &RimLoop::perimeter);
    const bool isFlat = turning(links, *longest) >= kNearlyATurn;
    for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
        const bool hole = smallHole > 0 && loop != longest &&
                          (loop->perimeter < smallHole * longest->perimeter ||
                           (isFlat && turning(links, *loop) <= -kNearlyATurn));
        (hole ? sorted.holes : sorted.openings).push_back(*loop);
    }
    return sorted;
}

}  // namespace toile
