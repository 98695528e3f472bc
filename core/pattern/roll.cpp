// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/roll.h"

#include <algorithm>
#include <utility>

#include "core/pattern/notch_mark.h"

namespace toile {

SeamRoll::SeamRoll(Seam seam, DrawnLoops& loops)
    : seam_(std::move(seam)), left_(loops.of(seam_.left)), right_(loops.of(seam_.right)) {}

double SeamRoll::directionAt(const SeamSide& side, const DrawnLoop& loop, double arc) const {
    const double at = loop.flatAt(arc);
    double from = at - kHalfChord, to = at + kHalfChord;
    if (!seam_.closed) {
        const auto [low, high] = std::minmax({loop.flatAt(side.start), loop.flatAt(side.end)});
        from = std::clamp(from, low, high);
        to = std::clamp(to, low, high);
    }
    if (side.reversed) {
        std::swap(from, to);
    }
    return directionTo(loop.flat.pointAt(from).transpose(), loop.flat.pointAt(to).transpose());
}

RolledPlace SeamRoll::at(double share) const {
    RolledPlace rolled{.at = placeAtShare(seam_, share)};
    Placement& motion = rolled.motion;
    motion.turn = wrappedAngle(directionAt(seam_.left, left_, rolled.at.left) -
                               directionAt(seam_.right, right_, rolled.at.right));
    motion.offset = left_.pointAt(rolled.at.left).transpose() -
                    motion.applied(right_.pointAt(rolled.at.right).transpose());
    rolled.walked = walkedTo(seam_, left_, right_, rolled.at);
    return rolled;
}

}  // namespace toile
