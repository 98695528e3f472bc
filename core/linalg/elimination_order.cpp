// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/geometry/buckets.h"

namespace toile::linalg {
namespace {

constexpr int kUndivided = 16;  ///< so many unknowns are eliminated as they come
constexpr double kLongest = 4;  ///< what lies between the sides of n unknowns, as a part of sqrt(n)
constexpr int kSmallest = 4000;  ///< where n is less it need not be looked at

/// Each unknown's neighbours.
geometry::Buckets<> neighboursIn(const SymmetricMatrix& pattern) {
    return geometry::Buckets<>(pattern.size, [&pattern](auto add) {
        for (int j = 0; j < pattern.size; ++j) {
            for (int k = pattern.columnStart[j] + 1; k < pattern.columnStart[j + 1]; ++k) {
                add(pattern.row[k], j);
                add(j, pattern.row[k]);
            }
        }
    });
}

int longestAxis(std::span<const int> unknowns, const Places& places) {
    Eigen::RowVector3d low = places.row(unknowns.front());
    Eigen::RowVector3d high = low;
    for (const int v : unknowns) {
        low = low.cwiseMin(places.row(v));
        high = high.cwiseMax(places.row(v));
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
}

}  // namespace

std::vector<int> eliminationOrder(const SymmetricMatrix& pattern, const Places& places) {
    const geometry::Buckets<> neighbours = neighboursIn(pattern);
    std::vector<int> order(static_cast<std::size_t>(pattern.size));
    std::iota(order.begin(), order.end(), 0);
    std::vector<int> cut(order.size(), 0);  // the last one that an unknown was on the near side of
    int cuts = 0;
    std::vector<std::span<int>> left{order};
    while (!left.empty()) {
        const std::span<int> range = left.back();
        left.pop_back();
        if (range.size() <= kUndivided) {
            continue;
        }
        const int axis = longestAxis(range, places);
        const auto middle = range.begin() + static_cast<std::ptrdiff_t>(range.size() / 2);
        std::nth_element(range.begin(), middle, range.end(), [&](int v, int w) {
            return std::pair(places(v, axis), v) < std::pair(places(w, axis), w);
        });
        ++cuts;
        std::for_each(range.begin(), middle, [&](int v) { cut[v] = cuts; });
        const auto between = std::partition(middle, range.end(), [&](int v) {
            return std::ranges::none_of(neighbours[v], [&](int w) { return cut[w] == cuts; });
        });
        if (range.size() > kSmallest &&
            static_cast<double>(range.end() - between) > kLongest * std::sqrt(range.size())) {
            return {};
        }
        left.emplace_back(range.begin(), middle);
        left.emplace_back(middle, between);
    }
    return order;
}

}  // namespace toile::linalg
