// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fine_polyline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/geometry/segment.h"

namespace toile {

FinePolyline::FinePolyline(const Points2& points, double length)
    : points_(points), turns_(static_cast<std::size_t>(points.rows()), 0), reached_{0} {
    assert(count() >= 2);
    for (int k = 0; k + 1 < count(); ++k) {
        const Eigen::Vector2d step = point(k + 1) - point(k);
        if (k > 0) {
            const Eigen::Vector2d before = point(k) - point(k - 1);
            turns_[k] = geometry::turnBetween(before, step);
            directions_.push_back(directions_.back() + turns_[k]);
        } else {
            directions_.push_back(std::atan2(step.y(), step.x()));
        }
        steps_.push_back(step.norm());
        reached_.push_back(reached_.back() + steps_.back());
    }
    const double scale = length / reached_.back();
    for (double& reached : reached_) {
        reached *= scale;
    }
    for (int k = 0; k < count(); ++k) {
        const double angle = isInside(k) ? directionAt(k) : directionAtEnd(k);
        tangents_.emplace_back(std::cos(angle), std::sin(angle));
    }
}

double FinePolyline::directionAt(int k) const {
    return (directions_[k - 1] * steps_[k] + directions_[k] * steps_[k - 1]) /
           (steps_[k] + steps_[k - 1]);
}

double FinePolyline::directionAtEnd(int k) const {
    const int side = k == 0 ? 1 : -1;
    const int step = k == 0 ? 0 : k - 1;
    const double near = isInside(k + side) ? curvature(k + side) : 0;
    const double change = isInside(k + 2 * side) ? curvature(k + 2 * side) - near : 0;
    // Half a step from the end, with the curvature at the middle of that half.
    return directions_[step] - side * 0.5 * steps_[step] * (near - 0.75 * change);
}

double FinePolyline::sag(int step) const {
    const double before = turns_[step > 0 ? step : std::min(1, count() - 1)];
    const double after = turns_[step + 2 < count() ? step + 1 : step];
    const double turn = std::min(std::abs(before), std::abs(after));
    return before * after > 0 ? turn * steps_[step] / 8 : 0;
}

}  // namespace toile
