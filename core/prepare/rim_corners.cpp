// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/rim_corners.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace toile {
namespace {

constexpr double kMaxRimLoss = 0.003;  // of length

// A corner may be removed if an edge at it is shorter than the first share of the wanted length,
// the new edge is not longer than the second, and the rim loses less than the third.
constexpr double kShortRimEdge = 0.5, kMaxRimEdge = 4.0 / 3, kMaxCornerLoss = 0.1;

}  // namespace

std::vector<int> findRimCorners(const Points3& V, const RimLoop& rim, double edgeLength) {
    using Loss = std::pair<double, int>;  // mm, corner
    const int count = static_cast<int>(rim.vertices.size());
    const auto distance = [&](int i, int j) {
        return (V.row(rim.vertices[i]) - V.row(rim.vertices[j])).norm();
    };

    std::vector<int> places{0};  // of the corners in the rim
    double spare = kMaxRimLoss * rim.perimeter, length = 0;
    for (int i = 0; i < count; ++i) {
        const int ahead = (i + 1) % count;
        const double step = distance(i, ahead), longer = length + step;
        const bool isCorner = longer - distance(places.back(), ahead) > kMaxRimLoss * longer;
        if (i > 0 && (isCorner || length + longer > 2 * edgeLength)) {
            spare -= length - distance(places.back(), i);
            places.push_back(i);
            length = step;
        } else {
            length = longer;
        }
    }
    spare -= length - distance(places.back(), 0);

    // The loss that is left pays for removing corners that make short edges, cheapest first.
    int left = static_cast<int>(places.size());
    std::vector<int> next(places.size()), previous(places.size());
    for (int k = 0; k < left; ++k) {
        next[k] = (k + 1) % left;
        previous[next[k]] = k;
    }
    std::priority_queue<Loss, std::vector<Loss>, std::greater<>> queue;
    const auto lossAt = [&](int k) {
        const double before = distance(places[previous[k]], places[k]);
        const double after = distance(places[k], places[next[k]]);
        const double chord = distance(places[previous[k]], places[next[k]]);
        const double loss = before + after - chord;
        return std::min(before, after) < kShortRimEdge * edgeLength &&
                       chord < kMaxRimEdge * edgeLength && loss < kMaxCornerLoss * edgeLength
                   ? loss
                   : rim.perimeter;
    };
    for (int k = 0; k < left; ++k) {
        queue.emplace(lossAt(k), k);
    }
    while (left > 3 && queue.top().first < spare) {
        const auto [loss, k] = queue.top();
        queue.pop();
        if (places[k] < 0 || lossAt(k) != loss) {
            continue;  // its neighbours have changed since
        }
        spare -= loss;
        places[k] = -1;
        --left;
        next[previous[k]] = next[k];
        previous[next[k]] = previous[k];
        queue.emplace(lossAt(next[k]), next[k]);
        queue.emplace(lossAt(previous[k]), previous[k]);
    }

    std::vector<int> corners;
    for (const int place : places) {
        if (place >= 0) {
            corners.push_back(rim.vertices[place]);
        }
    }
    return corners;
}

}  // namespace toile
