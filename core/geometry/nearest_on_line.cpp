// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/nearest_on_line.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/geometry/segment.h"

namespace toile::geometry {

NearestOnLine::NearestOnLine(const Polygon& closed) : points_(closed) {
    std::vector<std::uint32_t> edges;  // triangles without area
    const auto count = static_cast<std::uint32_t>(closed.rows());
    for (std::uint32_t k = 0; k < count; ++k) {
        edges.insert(edges.end(), {k, (k + 1) % count, k});
    }
    tree_ = TriangleTree<2, double>(points_.data(), 2, edges);
}

Eigen::RowVector2d NearestOnLine::operator()(const Eigen::RowVector2d& point) const {
    using Tree = TriangleTree<2, double>;
    Eigen::RowVector2d best = points_.row(0);
    std::pair least(std::numeric_limits<double>::infinity(), Eigen::Index{0});
    tree_.search(
        [&](const Tree::Box& box) {
            const Eigen::Map<const Eigen::RowVector2d> low(box.low.data()), high(box.high.data());
            const double square = (point.cwiseMax(low).cwiseMin(high) - point).squaredNorm();
            return square <= least.first ? square : Tree::kMissed;
        },
        [&](Eigen::Index k) {
            const Eigen::RowVector2d a = points_.row(k), b = points_.row((k + 1) % points_.rows());
            const Eigen::RowVector2d place = a + nearestShare(point, a, b) * (b - a);
            // Of equally close places take the first along the line, in any order of visits.
            if (const std::pair found((place - point).squaredNorm(), k); found < least) {
                least = found;
                best = place;
            }
        });
    return best;
}

}  // namespace toile::geometry
