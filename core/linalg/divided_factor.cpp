// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/divided_factor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/heap.h"
#include "core/base/thread_budget.h"
#include "core/linalg/dense_cholesky.h"

namespace toile {
namespace {

/// Unknowns from which on the second core gains a fifth and more: about 100 000 triangles.
constexpr int kLarge = 50000;
/// Of the unknowns: the smaller half has at least so many.
constexpr double kLeastHalf = 0.2;
/// Times the root of the unknowns: the separator is not longer.
constexpr double kLongestSeparator = 4;

}  // namespace

bool DividedFactor::isWorthIt(const EliminationOrder& order, int size) {
    const auto& end = order.halfEnd;
    const double least = kLeastHalf * size;
    return size >= kLarge && end[0] >= least && end[1] - end[0] >= least &&
           size - end[1] <= kLongestSeparator * std::sqrt(static_cast<double>(size));
}

Result<void> DividedFactor::analyse(const SymmetricMatrix& pattern, const EliminationOrder& order) {
    nodes_.clear();
    permutation_ = order.order;
    halfEnd_ = order.halfEnd;
    separatorStart_ = halfEnd_[1];
    const int separatorSize = pattern.size - separatorStart_;
    separatorRows_.resize(static_cast<std::size_t>(separatorSize));
    std::iota(separatorRows_.begin(), separatorRows_.end(), separatorStart_);
    placeInSeparator_.assign(static_cast<std::size_t>(pattern.size), -1);
    for (int s = 0; s < separatorSize; ++s) {
        placeInSeparator_[permutation_[separatorStart_ + s]] = s;
    }
    runSideBySide([&] { analyseHalf(halves_[0], 0, pattern); },
                  [&] { analyseHalf(halves_[1], 1, pattern); });
    for (const Half& half : halves_) {
        if (!half.outcome) {
            return half.outcome;
        }
    }
    return {};
}

void DividedFactor::analyseHalf(Half& half, int number, const SymmetricMatrix& pattern) {
    boundThreads();
    const int first = number == 0 ? 0 : halfEnd_[0];
    const int last = halfEnd_[static_cast<std::size_t>(number)];
    std::vector<int> unknowns(permutation_.begin() + first, permutation_.begin() + last);
    unknowns.insert(unknowns.end(), permutation_.begin() + separatorStart_, permutation_.end());
    half.size = static_cast<int>(unknowns.size());
    half.place.assign(permutation_.size(), -1);
    for (int k = 0; k < half.size; ++k) {
        half.place[unknowns[k]] = k;
    }
    cholmod_common& common = half.cholmod.common;
    common.supernodal = CHOLMOD_SUPERNODAL;
    half.outcome = half.cholmod.analyseOrdered(partOf(half, pattern, false));
    if (!half.outcome) {
        return;
    }
    // CHOLMOD may order anew where that changes nothing but the places of columns: parents still
    // come after their children, but not the separator after all the half.
    const cholmod_factor& factor = *half.cholmod.factor;
    std::vector<int> rowOf(unknowns.size());
    for (int k = 0, row = first; k < half.size; ++k) {
        const int u = unknowns[static_cast<const int*>(factor.Perm)[k]];
        half.place[u] = k;
        if (placeInSeparator_[u] >= 0) {
            rowOf[k] = separatorStart_ + placeInSeparator_[u];
        } else {
            rowOf[k] = row;
            permutation_[row++] = u;
        }
    }
    const int* rows = static_cast<const int*>(factor.s);
    half.rows.resize(factor.ssize);
    std::transform(rows, rows + factor.ssize, half.rows.begin(),
                   [&rowOf](int k) -> int { return rowOf[k]; });
}

/// The rows and columns of a half and of the separator, in the half's order. Columns are not
/// sorted.
SymmetricMatrix DividedFactor::partOf(const Half& half, const SymmetricMatrix& matrix,
                                      bool withValues) {
    const auto forEach = [&](const auto& visit) {
        for (int column = 0; column < matrix.size; ++column) {
            const int own = half.place[column];
            if (own < 0) {
                continue;
            }
            for (int k = matrix.columnStart[column]; k < matrix.columnStart[column + 1]; ++k) {
                if (const int other = half.place[matrix.row[k]]; other >= 0) {
                    visit(std::max(own, other), std::min(own, other), k);
                }
            }
        }
    };
    SymmetricMatrix part;
    part.size = half.size;
    part.columnStart.assign(static_cast<std::size_t>(half.size) + 1, 0);
    // The ends of columns become their beginnings as they are filled.
    forEach([&part](int, int column, int) { ++part.columnStart[column]; });
    std::partial_sum(part.columnStart.begin(), part.columnStart.end(), part.columnStart.begin());
    const auto entries = static_cast<std::size_t>(part.columnStart.back());
    part.row.resize(entries);
    part.value.resize(withValues ? entries : 0);
    forEach([&](int row, int column, int k) {
        const int at = --part.columnStart[column];
        part.row[at] = row;
        if (withValues) {
            part.value[at] = matrix.value[k];
        }
    });
    return part;
}

Result<void> DividedFactor::factorise(const SymmetricMatrix& matrix,
                                      const std::function<void()>& release) {
    nodes_.clear();
    std::array<SymmetricMatrix, 2> parts;
    runSideBySide([&] { parts[0] = partOf(halves_[0], matrix, true); },
                  [&] { parts[1] = partOf(halves_[1], matrix, true); });
    takeSeparator(matrix);
    release();
    returnFreedMemory();  // the factor is a large part of all that a piece needs
    runSideBySide([&] { factoriseHalf(halves_[0], std::move(parts[0])); },
                  [&] { factoriseHalf(halves_[1], std::move(parts[1])); });
    for (const Half& half : halves_) {
        if (!half.outcome) {
            return half.outcome;
        }
    }
    for (Half& half : halves_) {
        addLeft(half);
    }
    returnFreedMemory();  // the halves' matrices; right-hand sides come next
    if (!factoriseDense(separator_)) {
        return notPositiveDefinite();
    }
    for (std::size_t h = 0; h < halves_.size(); ++h) {
        addNodes(halves_[h]);
        nodeEnd_[h] = static_cast<int>(nodes_.size());
    }
    const int separatorSize = size() - separatorStart_;
    nodes_.push_back(
        {separatorStart_, separatorSize, separatorSize, separatorRows_.data(), separator_.data()});
    return {};
}

/// The separator's own entries stand in both halves, and are to stand once.
void DividedFactor::takeSeparator(const SymmetricMatrix& matrix) {
    const int separatorSize = size() - separatorStart_;
    separator_.setZero(separatorSize, separatorSize);
    for (int s = 0; s < separatorSize; ++s) {
        const int column = permutation_[separatorStart_ + s];
        for (int k = matrix.columnStart[column]; k < matrix.columnStart[column + 1]; ++k) {
            if (const int other = placeInSeparator_[matrix.row[k]]; other >= 0) {
                separator_(std::max(s, other), std::min(s, other)) = -matrix.value[k];
            }
        }
    }
}

void DividedFactor::factoriseHalf(Half& half, SymmetricMatrix part) {
    boundThreads();
    half.outcome = half.cholmod.factoriseOrdered(part);
    part = {};
    if (!half.outcome) {
        return;
    }
    squareLeft(half);
}

/// G G^T, the separator's part, in place of G where that stands in one block.
void DividedFactor::squareLeft(Half& half) {
    struct Column {
        const int* rows;
        double* entries;  ///< from the diagonal on
        int height, stride;
    };
    const cholmod_factor& factor = *half.cholmod.factor;
    const int* super = static_cast<const int*>(factor.super);
    const int* rowStart = static_cast<const int*>(factor.pi);
    const int* valueStart = static_cast<const int*>(factor.px);
    std::vector<Column> columns;
    for (std::size_t k = 0; k < factor.nsuper; ++k) {
        const int stride = rowStart[k + 1] - rowStart[k];
        const int* rows = half.rows.data() + rowStart[k];
        for (int c = 0; c < super[k + 1] - super[k]; ++c) {
            if (rows[c] >= separatorStart_) {
                double* entries = static_cast<double*>(factor.x) + valueStart[k] +
                                  static_cast<std::ptrdiff_t>(c) * (stride + 1);
                columns.push_back({rows + c, entries, stride - c, stride});
            }
        }
    }
    const int count = static_cast<int>(columns.size());
    const Column& first = columns.front();
    const bool isOneBlock = first.height == count && columns.back().stride == first.stride &&
                            columns.back().entries - first.entries ==
                                static_cast<std::ptrdiff_t>(count - 1) * (first.stride + 1);
    // G is triangular by the order in which CHOLMOD has taken the separator's unknowns: upper
    // triangular the other way round, which LAPACK can square.
    half.taken.resize(columns.size());
    std::vector<int> placeOf(columns.size());
    for (int c = 0; c < count; ++c) {
        const int place = count - 1 - c;
        half.taken[place] = columns[c].rows[0] - separatorStart_;
        placeOf[half.taken[place]] = place;
    }
    if (isOneBlock) {
        new (&half.left)
            DenseBlock(first.entries, count, count, Eigen::OuterStride<>(first.stride));
        for (int j = 0; 2 * j < count; ++j) {
            for (int i = 0; i < (2 * j + 1 < count ? count : count / 2); ++i) {
                std::swap(half.left(i, j), half.left(count - 1 - i, count - 1 - j));
            }
        }
    } else {
        half.apart.setZero(count, count);
        new (&half.left) DenseBlock(half.apart.data(), count, count, Eigen::OuterStride<>(count));
        for (int c = 0; c < count; ++c) {
            for (int i = 0; i < columns[c].height; ++i) {
                half.left(placeOf[columns[c].rows[i] - separatorStart_], count - 1 - c) =
                    columns[c].entries[i];
            }
        }
    }
    squareUpper(half.left);
}

/// Adds what a half leaves to the separator.
void DividedFactor::addLeft(Half& half) {
    for (Eigen::Index j = 0; j < half.left.cols(); ++j) {
        const int b = half.taken[static_cast<std::size_t>(j)];
        for (Eigen::Index i = 0; i <= j; ++i) {
            const int a = half.taken[static_cast<std::size_t>(i)];
            separator_(std::max(a, b), std::min(a, b)) += half.left(i, j);
        }
    }
    half.apart.resize(0, 0);
}

/// Nodes of a half without the separator's columns.
void DividedFactor::addNodes(const Half& half) {
    const cholmod_factor& factor = *half.cholmod.factor;
    const int* super = static_cast<const int*>(factor.super);
    const int* rowStart = static_cast<const int*>(factor.pi);
    const int* valueStart = static_cast<const int*>(factor.px);
    for (std::size_t k = 0; k < factor.nsuper; ++k) {
        const int* rows = half.rows.data() + rowStart[k];
        const int* last = rows + (super[k + 1] - super[k]);
        const auto width =
            std::find_if(rows, last, [this](int row) -> bool { return row >= separatorStart_; }) -
            rows;
        if (width > 0) {
            nodes_.push_back({rows[0], static_cast<int>(width), rowStart[k + 1] - rowStart[k], rows,
                              static_cast<const double*>(factor.x) + valueStart[k]});
        }
    }
}

Eigen::MatrixXd DividedFactor::solve(const Eigen::MatrixXd& B) const {
    const FactorView view(*this);
    FactorView::Panel X(B.rows(), B.cols());
    for (int i = 0; i < size(); ++i) {
        X.row(i) = B.row(permutation_[i]);
    }
    view.forward(X);
    view.backward(X);
    Eigen::MatrixXd solved(B.rows(), B.cols());
    for (int i = 0; i < size(); ++i) {
        solved.row(permutation_[i]) = X.row(i);
    }
    return solved;
}

std::size_t DividedFactor::bytes() const {
    std::size_t bytes = sizeof(int) * (permutation_.size() + placeInSeparator_.size()) +
                        sizeof(double) * static_cast<std::size_t>(separator_.size()) +
                        sizeof(FactorNode) * nodes_.size();
    for (const Half& half : halves_) {
        bytes += half.cholmod.bytes() + sizeof(int) * (half.place.size() + half.rows.size());
    }
    return bytes;
}

double DividedFactor::work() const {
    const double separatorSize = size() - separatorStart_;
    return halves_[0].cholmod.common.fl + halves_[1].cholmod.common.fl +
           separatorSize * separatorSize * separatorSize / 3;
}

}  // namespace toile
