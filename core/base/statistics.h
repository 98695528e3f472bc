// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace toile {

/// The value that a share of all values does not exceed, rounded to one of them; 0 of none.
/// @param share  in [0, 1]  Cost: linear.
template <class Value>
Value quantileOf(std::vector<Value> values, double share) {
    if (values.empty()) {
        return 0;
    }
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The middle value, of an even number of values the larger one of the two; 0 of none.
template <class Value>
Value medianOf(std::vector<Value> values) {
    if (values.empty()) {
        return 0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace toile
