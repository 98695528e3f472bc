// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "core/geometry/buckets.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile {

void SymmetricBuilder::add(int i, int j, double value) {
    entries_.push_back({std::max(i, j), std::min(i, j), value});
}

SymmetricMatrix SymmetricBuilder::build() const {
    // Two stable counting passes (by row, then by column) leave each column sorted by row.
    const auto countingPass = [this](const std::vector<int>& order, auto key) {
        return Buckets<>(size_,
                         [&](auto add) {
                             for (const int k : order) {
                                 add(key(entries_[k]), k);
                             }
                         })
            .items();
    };
    std::vector<int> order(entries_.size());
    std::iota(order.begin(), order.end(), 0);
    order = countingPass(order, [](const Entry& e) { return e.row; });
    order = countingPass(order, [](const Entry& e) { return e.column; });

    SymmetricMatrix matrix;
    matrix.size = size_;
    matrix.columnStart.assign(1, 0);
    std::size_t next = 0;
    for (int column = 0; column < size_; ++column) {
        matrix.row.push_back(column);
        matrix.value.push_back(0.0);
        for (; next < order.size() && entries_[order[next]].column == column; ++next) {
            const Entry& entry = entries_[order[next]];
            if (matrix.row.back() != entry.row) {
                matrix.row.push_back(entry.row);
                matrix.value.push_back(0.0);
            }
            matrix.value.back() += entry.value;
        }
        matrix.columnStart.push_back(static_cast<int>(matrix.row.size()));
    }
    return matrix;
}

}  // namespace toile
