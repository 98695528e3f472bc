// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/block_matrix.h"

#include <algorithm>

namespace toile::linalg {

// Columns 2 v and 2 v + 1 hold, in order, the diagonal block's lower triangle and two rows for each
// edge from v to a larger vertex, so positions follow from the edge's index alone.
BlockMatrix::BlockMatrix(const geometry::VertexPairs& edges, int vertexCount)
    : edges_(edges), firstEdge_(static_cast<std::size_t>(vertexCount) + 1, 0) {
    for (int e = 0; e < edges.rows(); ++e) {
        ++firstEdge_[edges(e, 0) + 1];
    }
    for (int v = 0; v < vertexCount; ++v) {
        firstEdge_[v + 1] += firstEdge_[v];
    }
    matrix_.size = 2 * vertexCount;
    matrix_.columnStart.assign(1, 0);
    matrix_.row.reserve(3 * static_cast<std::size_t>(vertexCount) +
                        4 * static_cast<std::size_t>(edges.rows()));
    for (int v = 0; v < vertexCount; ++v) {
        for (int axis = 0; axis < 2; ++axis) {
            for (int lower = axis; lower < 2; ++lower) {
                matrix_.row.push_back(2 * v + lower);
            }
            for (int e = firstEdge_[v]; e < firstEdge_[v + 1]; ++e) {
                matrix_.row.push_back(2 * edges(e, 1));
                matrix_.row.push_back(2 * edges(e, 1) + 1);
            }
            matrix_.columnStart.push_back(static_cast<int>(matrix_.row.size()));
        }
    }
    matrix_.value.assign(matrix_.row.size(), 0);
}

void BlockMatrix::setZero() {
    std::fill(matrix_.value.begin(), matrix_.value.end(), 0.0);
}

void BlockMatrix::scaleDiagonal(double factor) {
    for (int i = 0; i < matrix_.size; ++i) {
        matrix_.value[matrix_.columnStart[i]] *= factor;
    }
}

double BlockMatrix::largestOnDiagonal(int v) const {
    return std::max(*column(2 * v), *column(2 * v + 1));
}

void BlockMatrix::addVertex(int v, const Eigen::Matrix2d& block) {
    double* first = column(2 * v);
    first[0] += block(0, 0);
    first[1] += block(1, 0);
    *column(2 * v + 1) += block(1, 1);
}

void BlockMatrix::addEdge(int e, const Eigen::Matrix2d& block) {
    const int v = edges_(e, 0);
    const int k = 2 * (e - firstEdge_[v]);
    double* x = column(2 * v) + 2 + k;
    x[0] += block(0, 0);
    x[1] += block(1, 0);
    double* y = column(2 * v + 1) + 1 + k;
    y[0] += block(0, 1);
    y[1] += block(1, 1);
}

int BlockMatrix::findEdge(int v, int w) const {
    const auto [low, high] = std::minmax(v, w);
    int first = firstEdge_[low];
    int last = firstEdge_[low + 1];
    while (first < last) {
        const int middle = (first + last) / 2;
        if (edges_(middle, 1) < high) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    return first < firstEdge_[low + 1] && edges_(first, 1) == high ? first : -1;
}

BlockVector BlockMatrix::product(const BlockVector& x) const {
    BlockVector y(x.rows(), 2);
    for (int v = 0; v < static_cast<int>(x.rows()); ++v) {
        const double* first = column(2 * v);
        const double last = *column(2 * v + 1);
        y(v, 0) = first[0] * x(v, 0) + first[1] * x(v, 1);
        y(v, 1) = first[1] * x(v, 0) + last * x(v, 1);
    }
    for (int v = 0; v < static_cast<int>(x.rows()); ++v) {
        y.row(v) += above(v, x);
        addBelow(v, x.row(v), y);
    }
    return y;
}

BlockVector BlockMatrix::upperProduct(const BlockVector& x) const {
    BlockVector y(x.rows(), 2);
    for (int v = 0; v < static_cast<int>(x.rows()); ++v) {
        y.row(v) = above(v, x);
    }
    return y;
}

void BlockMatrix::sweepForth(BlockVector& x) const {
    for (int v = 0; v < static_cast<int>(x.rows()); ++v) {
        x.row(v) = solveVertex(v, x.row(v));
        addBelow(v, -x.row(v), x);
    }
}

void BlockMatrix::sweepBack(BlockVector& x) const {
    for (int v = static_cast<int>(x.rows()) - 1; v >= 0; --v) {
        x.row(v) = solveVertex(v, x.row(v) - above(v, x));
    }
}

/// Row v of the blocks above the diagonal, times x.
Eigen::RowVector2d BlockMatrix::above(int v, const BlockVector& x) const {
    const double* first = column(2 * v) + 2;
    const double* second = column(2 * v + 1) + 1;
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (int e = firstEdge_[v]; e < firstEdge_[v + 1]; ++e, first += 2, second += 2) {
        const double* of = x.data() + 2 * static_cast<std::ptrdiff_t>(edges_(e, 1));
        sum[0] += first[0] * of[0] + first[1] * of[1];
        sum[1] += second[0] * of[0] + second[1] * of[1];
    }
    return sum;
}

/// Adds column v of the blocks below the diagonal, times x, to y.
void BlockMatrix::addBelow(int v, const Eigen::RowVector2d& x, BlockVector& y) const {
    const double* first = column(2 * v) + 2;
    const double* second = column(2 * v + 1) + 1;
    for (int e = firstEdge_[v]; e < firstEdge_[v + 1]; ++e, first += 2, second += 2) {
        double* to = y.data() + 2 * static_cast<std::ptrdiff_t>(edges_(e, 1));
        to[0] += first[0] * x[0] + second[0] * x[1];
        to[1] += first[1] * x[0] + second[1] * x[1];
    }
}

/// Solves with the block of a vertex.
Eigen::RowVector2d BlockMatrix::solveVertex(int v, const Eigen::RowVector2d& right) const {
    const double* first = column(2 * v);
    const double last = *column(2 * v + 1);
    const double determinant = first[0] * last - first[1] * first[1];
    return Eigen::RowVector2d(last * right[0] - first[1] * right[1],
                              first[0] * right[1] - first[1] * right[0]) /
           determinant;
}

}  // namespace toile::linalg
