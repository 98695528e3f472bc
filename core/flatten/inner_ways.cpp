// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/inner_ways.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/mesh/tri_mesh.h"

namespace toile {

InnerWays::InnerWays(const Piece& piece)
    : piece_(piece),
      halfedges_(halfedgesOf(piece)),
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
}

std::vector<InnerWay> InnerWays::find(const std::vector<int>& sources,
                                      const std::vector<int>& targets) const {
    const Points3& V = piece_.mesh.V;
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
        for (const auto out : halfedges_.voh_range(TriMesh::VertexHandle(v))) {
            if (halfedges_.is_boundary(halfedges_.edge_handle(out))) {
                continue;
            }
            const int w = halfedges_.to_vertex_handle(out).idx();
            const double there = reached + (V.row(v) - V.row(w)).norm();
            if (there < distance[w]) {
                distance[w] = there;
                parent[w] = v;
                queue.emplace(there, w);
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
