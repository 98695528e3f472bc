// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <vector>

namespace toile::geometry {

/// Union-find over 0 .. size-1, with path halving. The root of a set is its smallest member, so
/// that results do not depend on the order of joins.
class DisjointSets {
public:
    explicit DisjointSets(int size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    int root(int x) {
        while (parent_[x] != x) {
            parent_[x] = parent_[parent_[x]];
            x = parent_[x];
        }
        return x;
    }

    void join(int a, int b) {
        a = root(a);
        b = root(b);
        (a < b ? parent_[b] : parent_[a]) = a < b ? a : b;
    }

private:
    std::vector<int> parent_;
};

}  // namespace toile::geometry
