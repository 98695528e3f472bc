// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/interior_paths.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

namespace toile {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

InteriorPaths::InteriorPaths(const Piece& piece)
    : piece_(piece),
      loopIndex_(static_cast<std::size_t>(piece.mesh.V.rows()), -1),
      isHoleRim_(loopIndex_.size(), false),
      neighbours_(static_cast<int>(loopIndex_.size()),
                  [&table = piece.table](auto add) {
                      for (int e = 0; e < table.edges.rows(); ++e) {
                          if (!table.isBorder(e)) {
                              add(table.edges(e, 0), table.edges(e, 1));
                              add(table.edges(e, 1), table.edges(e, 0));
                          }
                      }
                  }),
      distance_(loopIndex_.size(), kFar),
      parent_(loopIndex_.size(), -1) {
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        loopIndex_[piece.boundary[i]] = static_cast<int>(i);
    }
    for (const auto& hole : piece.holes) {
        for (const int v : hole) {
            isHoleRim_[v] = true;
        }
    }
}

void InteriorPaths::search(const std::vector<int>& sources, double longest) {
    const Points3& V = piece_.mesh.V;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int i : sources) {
        distance_[piece_.boundary[i]] = 0;
        reached_.push_back(piece_.boundary[i]);
        queue.emplace(0, piece_.boundary[i]);
    }
    while (!queue.empty()) {
        const auto [reached, v] = queue.top();
        queue.pop();
        const bool isEnd = loopIndex_[v] >= 0 && reached > 0;
        if (reached > distance_[v] || isEnd || isHoleRim_[v]) {
            continue;
        }
        for (const int w : neighbours_[v]) {
            const double there = reached + (V.row(v) - V.row(w)).norm();
            if (there < distance_[w] && there > longest) {
                hasLeftOut_ = true;
            } else if (there < distance_[w]) {
                if (distance_[w] == kFar) {
                    reached_.push_back(w);
                }
                distance_[w] = there;
                parent_[w] = v;
                queue.emplace(there, w);
            }
        }
    }
}

std::vector<InteriorPath> InteriorPaths::find(const std::vector<int>& sources,
                                              const std::vector<int>& targets, double longest) {
    hasLeftOut_ = false;
    search(sources, longest);
    std::vector<InteriorPath> paths;
    for (const int i : targets) {
        const int end = piece_.boundary[i];
        if (parent_[end] < 0) {
            continue;  // a source, or unreachable
        }
        InteriorPath path{-1, i, {}, distance_[end]};
        for (int v = end; v >= 0; v = parent_[v]) {
            path.vertices.push_back(v);
        }
        std::reverse(path.vertices.begin(), path.vertices.end());
        path.from = loopIndex_[path.vertices.front()];
        paths.push_back(std::move(path));
    }
    for (const int v : reached_) {
        distance_[v] = kFar;
        parent_[v] = -1;
    }
    reached_.clear();
    return paths;
}

}  // namespace toile
