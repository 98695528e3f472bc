// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/quality/measures.h"

namespace toile {
namespace {

/// Distance from a line, relative to the outline's extent, below which a point lies on it.
constexpr double kTouching = 1e-12;
/// The sweep runs at a slant, so that upright and level stretches of outline do not all overlap.
constexpr double kSlant = 0.6;  // radians

/// On which side of the line through p and q the point r lies: 1 left, -1 right, 0 on it.
int side(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q, const Eigen::RowVector2d& r,
         double touching) {
    const Eigen::RowVector2d along = q - p;
    const Eigen::RowVector2d to = r - p;
    const double doubledArea = along.x() * to.y() - along.y() * to.x();
    if (std::abs(doubledArea) <= touching * along.norm()) {
        return 0;
    }
    return doubledArea > 0 ? 1 : -1;
}

/// One outline edge with its extent along and across the sweep.
struct Segment {
    Eigen::RowVector2d a, b;
    double first, last, low, high;
};

bool cross(const Segment& s, const Segment& t, double touching) {
    return s.low <= t.high && t.low <= s.high &&
           side(s.a, s.b, t.a, touching) * side(s.a, s.b, t.b, touching) < 0 &&
           side(t.a, t.b, s.a, touching) * side(t.a, t.b, s.b, touching) < 0;
}

}  // namespace

int outlineCrossings(const Points2& Q, const std::vector<int>& boundary) {
    const int n = static_cast<int>(boundary.size());
    const Eigen::RowVector2d sweep(std::cos(kSlant), std::sin(kSlant));
    const Eigen::RowVector2d across(-sweep.y(), sweep.x());
    std::vector<Segment> segments(n);
    double extent = 0;
    for (int i = 0; i < n; ++i) {
        Segment& s = segments[i];
        s.a = Q.row(boundary[i]);
        s.b = Q.row(boundary[(i + 1) % n]);
        std::tie(s.first, s.last) = std::minmax({s.a.dot(sweep), s.b.dot(sweep)});
        std::tie(s.low, s.high) = std::minmax({s.a.dot(across), s.b.dot(across)});
        extent = std::max(extent, (s.a - segments.front().a).norm());
    }
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return std::tie(segments[i].first, i) < std::tie(segments[j].first, j);
    });
    int crossings = 0;
    for (int k = 0; k < n; ++k) {
        const Segment& s = segments[order[k]];
        for (int m = k + 1; m < n && segments[order[m]].first <= s.last; ++m) {
            const int apart = std::abs(order[m] - order[k]);
            if (apart > 1 && apart < n - 1 && cross(s, segments[order[m]], kTouching * extent)) {
                ++crossings;
            }
        }
    }
    return crossings;
}

}  // namespace toile
