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
    std::vector<double> turns;
    for (const RimLoop& loop : loops) {
        turns.push_back(turning(links, loop));
    }
    // The outline is the longest loop, but for a flat piece with a slit longer than that.
    auto outline = std::ranges::max_element(loops, {}, &RimLoop::perimeter) - loops.begin();
    const double longest = loops[outline].perimeter;
    if (turns[outline] <= -kNearlyATurn) {
        outline = std::ranges::max_element(turns) - turns.begin();
    }
    const bool isFlat = turns[outline] >= kNearlyATurn;
    for (std::ptrdiff_t k = 0; k < std::ssize(loops); ++k) {
        const bool hole =
            smallHole > 0 && k != outline &&
            (loops[k].perimeter < smallHole * longest || (isFlat && turns[k] <= -kNearlyATurn));
        (hole ? sorted.holes : sorted.openings).push_back(std::move(loops[k]));
    }
    return sorted;
}

}  // namespace toile
