// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace toile::shell {

/// Union-find over 0 .. size-1 in which each member of a set is on one of two sides. The root of a
/// set is its smallest member.
class TwoSided {
public:
    explicit TwoSided(int size) : parent_(size), flipped_(size, 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    struct Place {
        int root;
        bool isFlipped;  ///< on the other side than the root
    };

    Place find(int x) {
        int root = x;
        bool isFlipped = false;
        while (parent_[root] != root) {
            isFlipped ^= flipped_[root] != 0;
            root = parent_[root];
        }
        const Place place{root, isFlipped};
        while (parent_[x] != root && x != root) {
            const int next = std::exchange(parent_[x], root);
            const char step = std::exchange(flipped_[x], isFlipped ? 1 : 0);
            isFlipped ^= step != 0;
            x = next;
        }
        return place;
    }

    /// Ignored if the two are in one set already.
    void join(int a, int b, bool areApart) {
        const Place at = find(a), to = find(b);
        if (at.root != to.root) {
            const auto [low, high] = std::minmax(at.root, to.root);
            parent_[high] = low;
            flipped_[high] = (at.isFlipped != to.isFlipped) != areApart ? 1 : 0;
        }
    }

private:
    std::vector<int> parent_;
    std::vector<char> flipped_;  ///< relative to the parent
};

}  // namespace toile::shell
