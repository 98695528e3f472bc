// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <vector>

namespace toile {

/// A graph made of ways along edges, to be taken apart at its branchings.
class EdgeSet {
public:
    void add(const std::vector<int>& way) {
        for (std::size_t i = 1; i < way.size(); ++i) {
            neighbours_[way[i - 1]].insert(way[i]);
            neighbours_[way[i]].insert(way[i - 1]);
        }
    }

    /// Takes away what dangles, until every end is part of a loop.
    void prune() {
        std::vector<int> ends;
        for (const auto& [v, around] : neighbours_) {
            ends.push_back(v);
        }
        while (!ends.empty()) {
            const int v = ends.back();
            ends.pop_back();
            if (neighbours_[v].size() == 1) {
                const int w = *neighbours_[v].begin();
                remove(v, w);
                ends.push_back(w);
            }
        }
    }

    /// The graph as ways between its branchings and ends; a loop without either starts anywhere.
    std::vector<std::vector<int>> takeApart() {
        std::set<int> stops;
        for (const auto& [v, around] : neighbours_) {
            if (around.size() != 2) {
                stops.insert(v);
            }
        }
        std::vector<std::vector<int>> ways;
        for (const int v : stops) {
            while (!neighbours_[v].empty()) {
                ways.push_back(walk(v, stops));
            }
        }
        for (const auto& [v, around] : neighbours_) {
            if (!around.empty()) {
                ways.push_back(walk(v, {v}));
            }
        }
        return ways;
    }

private:
    void remove(int v, int w) {
        neighbours_[v].erase(w);
        neighbours_[w].erase(v);
    }

    std::vector<int> walk(int v, const std::set<int>& stops) {
        std::vector<int> way{v};
        do {
            const int next = *neighbours_[v].begin();
            remove(v, next);
            v = next;
            way.push_back(v);
        } while (!stops.contains(v));
        return way;
    }

    std::map<int, std::set<int>> neighbours_;
};

}  // namespace toile
