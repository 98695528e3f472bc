// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/inner_ways.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace toile {

InnerWays::InnerWays(const Piece& piece)
    : piece_(piece),
      start_(static_cast<std::size_t>(piece.mesh.V.rows()) + 1, 0),
      loopIndex_(static_cast<std::size_t>(piece.mesh.V.rows()), -1),
      isHoleRim_(static_cast<std::size_t>(piece.mesh.V.rows()), false) {
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        loopIndex_[piece.boundary[i]] = static_cast<int>(i);
    }
    for (const auto& hole : piece.holes) {
        for (const int v : hole) {
            isHoleRim_[v] = true;
        }
    }
    const EdgeTable& table = piece.table;
    const auto isInner = [&](int e) { return table.useStart[e + 1] - table.useStart[e] == 2; };
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (isInner(e)) {
            ++start_[table.edges(e, 0) + 1];
            ++start_[table.edges(e, 1) + 1];
        }
    }
    for (std::size_t v = 1; v < start_.size(); ++v) {
        start_[v] += start_[v - 1];
    }
    neighbour_.resize(start_.back());
    length_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (isInner(e)) {
            const int v = table.edges(e, 0);
            const int w = table.edges(e, 1);
            const double length = (piece.mesh.V.row(v) - piece.mesh.V.row(w)).norm();
            neighbour_[next[v]] = w;
            length_[next[v]++] = length;
            neighbour_[next[w]] = v;
            length_[next[w]++] = length;
        }
    }
}

std::vector<InnerWay> InnerWays::find(const std::vector<int>& sources,
                                      const std::vector<int>& targets) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<double> distance(loopIndex_.size(), kFar);
    std::vector<int> parent(loopIndex_.size(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int i : sources) {
        distance[piece_.boundary[i]] = 0;
        queue.emplace(0, piece_.boundary[i]);
    }
    while (!queue.empty()) {
        const auto [reached, v] = queue.top();
        queue.pop();
        const bool isEnd = loopIndex_[v] >= 0 && reached > 0;
        if (reached > distance[v] || isEnd || isHoleRim_[v]) {
            continue;
        }
        for (int k = start_[v]; k < start_[v + 1]; ++k) {
            if (reached + length_[k] < distance[neighbour_[k]]) {
                distance[neighbour_[k]] = reached + length_[k];
                parent[neighbour_[k]] = v;
                queue.emplace(distance[neighbour_[k]], neighbour_[k]);
            }
        }
    }
    std::vector<InnerWay> ways;
    for (const int i : targets) {
        const int end = piece_.boundary[i];
        if (parent[end] < 0) {
            continue;  // a source, or out of reach
        }
        InnerWay way{-1, i, {}, distance[end]};
        for (int v = end; v >= 0; v = parent[v]) {
            way.path.push_back(v);
        }
        std::reverse(way.path.begin(), way.path.end());
        way.from = loopIndex_[way.path.front()];
        ways.push_back(std::move(way));
    }
    return ways;
}

}  // namespace toile
