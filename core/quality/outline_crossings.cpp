// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/quality/measures.h"

namespace toile {
namespace {

/// Sign of the doubled area of p, q, r. A double's error bound decides nearly always; what it
/// cannot decide is recomputed in extended precision.
int orientation(const Eigen::RowVector2d& p, const Eigen::RowVector2d& q,
                const Eigen::RowVector2d& r) {
    const double left = (q.x() - p.x()) * (r.y() - p.y());
    const double right = (q.y() - p.y()) * (r.x() - p.x());
    const double area = left - right;
    constexpr double kRelativeError = 4.5e-16;  // of three subtractions and two products
    if (std::abs(area) > kRelativeError * (std::abs(left) + std::abs(right))) {
        return area > 0 ? 1 : -1;
    }
    using Wide = long double;
    const Wide wide = (Wide(q.x()) - Wide(p.x())) * (Wide(r.y()) - Wide(p.y())) -
                      (Wide(q.y()) - Wide(p.y())) * (Wide(r.x()) - Wide(p.x()));
    return wide > 0 ? 1 : (wide < 0 ? -1 : 0);
}

/// One outline edge with its bounding box.
struct Segment {
    Eigen::RowVector2d a, b;
    double left, right, bottom, top;
};

bool cross(const Segment& s, const Segment& t) {
    return s.bottom <= t.top && t.bottom <= s.top &&
           orientation(s.a, s.b, t.a) * orientation(s.a, s.b, t.b) < 0 &&
           orientation(t.a, t.b, s.a) * orientation(t.a, t.b, s.b) < 0;
}

}  // namespace

int outlineCrossings(const Points2& Q, const std::vector<int>& boundary) {
    const int n = static_cast<int>(boundary.size());
    std::vector<Segment> segments(n);
    double width = 0;
    double height = 0;
    const auto extent = [&](int axis) {
        const auto values = Q(boundary, axis);
        return values.maxCoeff() - values.minCoeff();
    };
    if (n > 0) {
        width = extent(0);
        height = extent(1);
    }
    // Sweep along the longer side of the outline: fewer edges overlap there.
    const int sweep = width >= height ? 0 : 1;
    for (int i = 0; i < n; ++i) {
        Segment& s = segments[i];
        s.a = Q.row(boundary[i]);
        s.b = Q.row(boundary[(i + 1) % n]);
        std::tie(s.left, s.right) = std::minmax({s.a[sweep], s.b[sweep]});
        std::tie(s.bottom, s.top) = std::minmax({s.a[1 - sweep], s.b[1 - sweep]});
    }
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return segments[i].left != segments[j].left ? segments[i].left < segments[j].left : i < j;
    });
    int crossings = 0;
    for (int k = 0; k < n; ++k) {
        const Segment& s = segments[order[k]];
        for (int m = k + 1; m < n && segments[order[m]].left <= s.right; ++m) {
            const int apart = std::abs(order[m] - order[k]);
            if (apart > 1 && apart < n - 1 && cross(s, segments[order[m]])) {
                ++crossings;
            }
        }
    }
    return crossings;
}

}  // namespace toile
