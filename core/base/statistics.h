// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace toile {

/// The quantile of a share, rounded down to one of the values; 0 if there are none.
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

/// The median, of an even number of values the larger of the middle two; 0 if there are none.
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
