// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <span>
#include <vector>

namespace toile::geometry {

/// Items grouped by a key from 0 on; items of one key keep the order in which they came: the edges
/// at each vertex, the triangles of each face. Two passes over the items, no sorting.
template <class Item = int>
class Buckets {
public:
    Buckets() = default;

    /// @param forEach  calls its argument with the key and the item of each; it runs twice and must
    ///                 give the same pairs both times
    /// Cost: linear in keys and items.
    template <class ForEach>
    Buckets(int keyCount, ForEach&& forEach) : start_(static_cast<std::size_t>(keyCount) + 1, 0) {
        forEach([this](int key, const Item&) { ++start_[key + 1]; });
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        items_.resize(static_cast<std::size_t>(start_.back()));
        std::vector<int> next(start_.begin(), start_.end() - 1);
        forEach([this, &next](int key, const Item& item) { items_[next[key]++] = item; });
    }

    int keyCount() const { return static_cast<int>(start_.size()) - 1; }

    /// Precondition: 0 <= key < keyCount.
    std::span<const Item> operator[](int key) const {
        return {items_.data() + start_[key], items_.data() + start_[key + 1]};
    }
    std::span<Item> operator[](int key) {
        return {items_.data() + start_[key], items_.data() + start_[key + 1]};
    }

    /// All items, ordered by key.
    const std::vector<Item>& items() const { return items_; }

private:
    std::vector<int> start_{0};  ///< of each key's items; one more for the end
    std::vector<Item> items_;
};

}  // namespace toile::geometry
