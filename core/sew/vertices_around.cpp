// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/vertices_around.h"

#include <algorithm>
#include <limits>

namespace toile::sew {

Neighbours neighboursOf(const Cloth& cloth) {
    Neighbours neighbours(static_cast<std::size_t>(cloth.X.rows()));
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int a = cloth.F(f, k), b = cloth.F(f, (k + 1) % 3);
            const double length =
                (cloth.Q.row(cloth.patternF(f, k)) - cloth.Q.row(cloth.patternF(f, (k + 1) % 3)))
                    .norm();
            neighbours[a].emplace_back(b, length);
            neighbours[b].emplace_back(a, length);
        }
    }
    return neighbours;
}

void VerticesAround::reach(int vertex) {
    if (requestedAt_[vertex] != requested_) {
        requestedAt_[vertex] = requested_;
        wayTo_[vertex] = std::numeric_limits<double>::infinity();
        reached_.push_back(vertex);
    }
}

void VerticesAround::shorten(int vertex, double way) {
    reach(vertex);
    if (way < wayTo_[vertex]) {
        wayTo_[vertex] = way;
        open_.emplace(way, vertex);
    }
}

std::vector<int> VerticesAround::of(const std::vector<int>& seeds) {
    ++requested_;
    reached_.clear();
    for (const int seed : seeds) {
        shorten(seed, 0);
    }
    std::size_t next = 0;
    for (int ring = 0; ring < rings_; ++ring) {
        for (const std::size_t end = reached_.size(); next < end; ++next) {
            for (const auto& [vertex, length] : neighbours_[reached_[next]]) {
                reach(vertex);
            }
        }
    }
    while (!open_.empty()) {
        const auto [way, from] = open_.top();
        open_.pop();
        if (way > wayTo_[from]) {
            continue;
        }
        for (const auto& [vertex, length] : neighbours_[from]) {
            if (way + length <= far_) {
                shorten(vertex, way + length);
            }
        }
    }
    std::vector<int> around = reached_;
    std::ranges::sort(around);
    return around;
}

}  // namespace toile::sew
