// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/space_matrix.h"

#include <algorithm>
#include <cassert>

namespace toile::sew {

// Column 3 v + k has the diagonal block's rows from k on, and three rows for each pair with a
// larger vertex; each position follows from the pair's number alone.
SpaceMatrix::SpaceMatrix(std::vector<std::pair<int, int>> pairs, int vertexCount)
    : firstPair_(static_cast<std::size_t>(vertexCount) + 1, 0) {
    for (auto& [v, w] : pairs) {
        if (v > w) {
            std::swap(v, w);
        }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [v, w] : pairs) {
        ++firstPair_[v + 1];
        larger_.push_back(w);
    }
    for (int v = 0; v < vertexCount; ++v) {
        firstPair_[v + 1] += firstPair_[v];
    }
    matrix_.size = 3 * vertexCount;
    matrix_.columnStart.assign(1, 0);
    for (int v = 0; v < vertexCount; ++v) {
        for (int k = 0; k < 3; ++k) {
            for (int row = k; row < 3; ++row) {
                matrix_.row.push_back(3 * v + row);
            }
            for (int pair = firstPair_[v]; pair < firstPair_[v + 1]; ++pair) {
                for (int row = 0; row < 3; ++row) {
                    matrix_.row.push_back(3 * larger_[pair] + row);
                }
            }
            matrix_.columnStart.push_back(static_cast<int>(matrix_.row.size()));
        }
    }
    matrix_.value.assign(matrix_.row.size(), 0);
}

void SpaceMatrix::setZero() {
    std::ranges::fill(matrix_.value, 0.0);
}

void SpaceMatrix::addToDiagonal(int v, double value) {
    for (int k = 0; k < 3; ++k) {
        matrix_.value[matrix_.columnStart[3 * v + k]] += value;
    }
}

void SpaceMatrix::add(int v, int w, const Eigen::Matrix3d& block) {
    const int low = std::min(v, w), high = std::max(v, w);
    if (low == high) {
        for (int k = 0; k < 3; ++k) {
            double* column = &matrix_.value[matrix_.columnStart[3 * v + k]];
            for (int row = k; row < 3; ++row) {
                column[row - k] += block(row, k);
            }
        }
        return;
    }
    const auto first = larger_.begin() + firstPair_[low];
    const auto last = larger_.begin() + firstPair_[low + 1];
    const auto found = std::lower_bound(first, last, high);
    assert(found != last && *found == high);
    const auto number = found - first;
    for (int k = 0; k < 3; ++k) {
        double* column = &matrix_.value[matrix_.columnStart[3 * low + k] + 3 - k + 3 * number];
        for (int row = 0; row < 3; ++row) {
            column[row] += v == high ? block(row, k) : block(k, row);
        }
    }
}

}  // namespace toile::sew
