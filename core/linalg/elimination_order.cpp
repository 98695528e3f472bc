// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <cholmod.h>

#include "core/geometry/buckets.h"

namespace toile::linalg {
namespace {

constexpr int kUndivided = 16;   ///< a set of this size is not divided further
constexpr double kLongest = 4;   ///< largest separator of n unknowns, as a multiple of sqrt(n)
constexpr int kSmallest = 4000;  ///< smaller sets are not checked

/// The neighbours of each unknown.
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
    std::vector<int> cut(order.size(), 0);  // last cut with an unknown on its near side
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

std::vector<int> dissectedOrder(const SymmetricMatrix& pattern, int together) {
    std::vector<int> start{0}, row;  // first unknown of each group that stays together
    for (int j = 0; j < pattern.size; j += together) {
        for (int k = pattern.columnStart[j]; k < pattern.columnStart[j + 1]; ++k) {
            if (pattern.row[k] % together == 0) {
                row.push_back(pattern.row[k] / together);
            }
        }
        start.push_back(static_cast<int>(row.size()));
    }
    cholmod_common common{};
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NESDIS;
    cholmod_sparse view{};
    view.nrow = view.ncol = start.size() - 1;
    view.nzmax = row.size();
    view.p = start.data();
    view.i = row.data();
    view.stype = -1;  // lower triangle stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_PATTERN;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    std::vector<int> order;
    cholmod_factor* factor = cholmod_analyze(&view, &common);
    if (factor != nullptr) {
        const int* const first = static_cast<const int*>(factor->Perm);
        for (std::size_t v = 0; v < view.nrow; ++v) {
            for (int k = 0; k < together; ++k) {
                order.push_back(together * first[v] + k);
            }
        }
    }
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
    return order;
}

}  // namespace toile::linalg
