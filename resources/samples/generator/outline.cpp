// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline.h"

#include <stdexcept>

namespace toile::samples {

namespace {

constexpr double kJointTolerance = 1e-6;  // mm; sides are computed from the same formulas

bool meets(Vec2 flatA, Vec3 spaceA, Vec2 flatB, Vec3 spaceB) {
    return length(flatA - flatB) < kJointTolerance && length(spaceA - spaceB) < kJointTolerance;
}

std::size_t source(std::size_t k, std::size_t count, Outline::Direction direction) {
    return direction == Outline::Direction::Forward ? k : count - 1 - k;
}

}  // namespace

void Outline::append(Vec2 flat, Vec3 space, bool firstOfSide, bool onFold) {
    if (firstOfSide && !flat_.empty()) {
        if (!meets(flat_.back(), space_.back(), flat, space)) {
            throw std::logic_error("outline sides do not meet");
        }
        onFold_.back() = onFold_.back() || onFold;
        return;
    }
    flat_.push_back(flat);
    space_.push_back(space);
    onFold_.push_back(onFold);
}

void Outline::add(const SeamLine& seam, const FlatCurve& flat, Direction direction, Fold fold) {
    const std::size_t count = seam.points.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t s = source(k, count, direction);
        append(flat(seam.parameters[s]), seam.points[s], k == 0, fold == Fold::Yes);
    }
}

void Outline::addByLength(const SeamLine& seam, const FlatCurve& flat, Direction direction,
                          Fold fold) {
    const std::size_t count = seam.points.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t s = source(k, count, direction);
        const double fraction = static_cast<double>(s) / static_cast<double>(count - 1);
        append(flat(fraction), seam.points[s], k == 0, fold == Fold::Yes);
    }
}

void Outline::close() {
    if (!meets(flat_.back(), space_.back(), flat_.front(), space_.front())) {
        throw std::logic_error("outline does not close");
    }
    onFold_.front() = onFold_.front() || onFold_.back();
    flat_.pop_back();
    space_.pop_back();
    onFold_.pop_back();
}

}  // namespace toile::samples
