// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/factor_view.h"

#include <algorithm>
#include <array>

namespace toile {
namespace {

using Panel = FactorView::Panel;
using Block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Columns of a panel that are not all zero so far at a node.
struct Span {
    int from, to;

    void include(const Span& other) {
        from = std::min(from, other.from);
        to = std::max(to, other.to);
    }
};

/// The columns between the first and the last that is not zero in a row.
Span spanOf(const Panel& X, Eigen::Index row) {
    const int count = static_cast<int>(X.cols());
    int from = 0;
    while (from < count && X(row, from) == 0) {
        ++from;
    }
    int to = count;
    while (to > from && X(row, to - 1) == 0) {
        --to;
    }
    return from < to ? Span{from, to} : Span{count, 0};
}

}  // namespace

FactorView::FactorView(const cholmod_factor& factor)
    : factor_(&factor),
      size_(static_cast<int>(factor.n)),
      permutation_(static_cast<const int*>(factor.Perm)) {}

bool FactorView::isReadable(const cholmod_factor& factor) {
    return factor.xtype == CHOLMOD_REAL && factor.itype == CHOLMOD_INT && factor.is_ll != 0 &&
           factor.minor == factor.n && factor.x != nullptr;
}

int FactorView::nodeCount() const {
    return static_cast<int>(factor_->is_super != 0 ? factor_->nsuper : factor_->n);
}

FactorView::Node FactorView::node(int k) const {
    const auto* value = static_cast<const double*>(factor_->x);
    if (factor_->is_super != 0) {
        const int* super = static_cast<const int*>(factor_->super);
        const int* rowStart = static_cast<const int*>(factor_->pi);
        const int* valueStart = static_cast<const int*>(factor_->px);
        return {super[k], super[k + 1] - super[k], rowStart[k + 1] - rowStart[k],
                static_cast<const int*>(factor_->s) + rowStart[k], value + valueStart[k]};
    }
    const int start = static_cast<const int*>(factor_->p)[k];
    return {k, 1, static_cast<const int*>(factor_->nz)[k],
            static_cast<const int*>(factor_->i) + start, value + start};
}

FactorReach FactorView::reachOf(const std::vector<int>& columns) const {
    std::vector<int> nodeOf;  // of each column, where a node has several
    if (factor_->is_super != 0) {
        nodeOf.resize(static_cast<std::size_t>(size_));
        for (int k = 0; k < nodeCount(); ++k) {
            const Node at = node(k);
            std::fill_n(nodeOf.begin() + at.first, at.width, k);
        }
    }
    FactorReach reach;
    std::vector<char> seen(static_cast<std::size_t>(nodeCount()), 0);
    for (const int column : columns) {
        for (int k = nodeOf.empty() ? column : nodeOf[column]; seen[k] == 0;) {
            seen[k] = 1;
            reach.nodes.push_back(k);
            const Node at = node(k);
            if (at.height == at.width) {
                break;
            }
            const int parent = at.rows[at.width];
            k = nodeOf.empty() ? parent : nodeOf[parent];
        }
    }
    std::sort(reach.nodes.begin(), reach.nodes.end());
    reach.position.assign(static_cast<std::size_t>(size_), -1);
    for (const int k : reach.nodes) {
        const Node at = node(k);
        for (int c = 0; c < at.width; ++c) {
            reach.position[at.first + c] = static_cast<int>(reach.columns.size());
            reach.columns.push_back(at.first + c);
        }
    }
    return reach;
}

double FactorView::workOn(const FactorReach& reach) const {
    double work = 0;
    for (const int k : reach.nodes) {
        const Node at = node(k);
        work += static_cast<double>(at.width) * (at.height - 0.5 * at.width);
    }
    return work;
}

void FactorView::forwardOn(const FactorReach& reach, Panel& X) const {
    std::vector<Span> spans(reach.columns.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        spans[i] = spanOf(X, static_cast<Eigen::Index>(i));
    }
    Panel below;
    for (const int k : reach.nodes) {
        const Node at = node(k);
        const int row = reach.position[at.first];
        Span span = spans[row];
        for (int c = 1; c < at.width; ++c) {
            span.include(spans[row + c]);
        }
        const int count = span.to - span.from;
        if (count <= 0) {
            continue;
        }
        for (int i = at.width; i < at.height; ++i) {
            spans[reach.position[at.rows[i]]].include(span);
        }
        if (at.width == 1) {
            auto own = X.row(row).segment(span.from, count);
            own /= at.value[0];
            for (int i = 1; i < at.height; ++i) {
                X.row(reach.position[at.rows[i]]).segment(span.from, count) -= at.value[i] * own;
            }
            continue;
        }
        const Block L(at.value, at.height, at.width, Eigen::OuterStride<>(at.height));
        auto own = X.block(row, span.from, at.width, count);
        L.topRows(at.width).triangularView<Eigen::Lower>().solveInPlace(own);
        below.noalias() = L.bottomRows(at.height - at.width) * own;
        for (int i = at.width; i < at.height; ++i) {
            X.row(reach.position[at.rows[i]]).segment(span.from, count) -= below.row(i - at.width);
        }
    }
}

template <int R>
void FactorView::forwardFew(Panel& X) const {
    using Row = Eigen::Matrix<double, 1, R>;
    const auto rowOf = [all = X.data()](int row) -> double* {
        return all + static_cast<std::ptrdiff_t>(row) * R;
    };
    std::vector<double> below;  // of each right-hand side in turn
    for (int k = 0; k < nodeCount(); ++k) {
        const Node at = node(k);
        double* const first = rowOf(at.first);
        if (at.width == 1) {
            Eigen::Map<Row> own(first);
            own /= at.value[0];
            const Row x = own;
            for (int i = 1; i < at.height; ++i) {
                Eigen::Map<Row>(rowOf(at.rows[i])) -= at.value[i] * x;
            }
            continue;
        }
        const int rest = at.height - at.width;
        below.assign(static_cast<std::size_t>(rest) * R, 0);
        for (int c = 0; c < at.width; ++c) {
            const double* column = at.value + static_cast<std::ptrdiff_t>(c) * at.height;
            Eigen::Map<Row> own(first + static_cast<std::ptrdiff_t>(c) * R);
            own /= column[c];
            const Row x = own;
            for (int i = c + 1; i < at.width; ++i) {
                Eigen::Map<Row>(first + static_cast<std::ptrdiff_t>(i) * R) -= column[i] * x;
            }
            for (int r = 0; r < R; ++r) {
                double* sum = below.data() + static_cast<std::ptrdiff_t>(r) * rest;
                const double* entry = column + at.width;
                for (int i = 0; i < rest; ++i) {
                    sum[i] += entry[i] * x[r];
                }
            }
        }
        for (int i = 0; i < rest; ++i) {
            double* row = rowOf(at.rows[at.width + i]);
            for (int r = 0; r < R; ++r) {
                row[r] -= below[static_cast<std::size_t>(r) * rest + i];
            }
        }
    }
}

template <int R>
void FactorView::backwardFew(Panel& X) const {
    using Row = Eigen::Matrix<double, 1, R>;
    const auto rowOf = [all = X.data()](int row) -> double* {
        return all + static_cast<std::ptrdiff_t>(row) * R;
    };
    std::vector<double> below;
    for (int k = nodeCount() - 1; k >= 0; --k) {
        const Node at = node(k);
        double* const first = rowOf(at.first);
        if (at.width == 1) {
            Row x = Eigen::Map<Row>(first);
            for (int i = 1; i < at.height; ++i) {
                x -= at.value[i] * Eigen::Map<const Row>(rowOf(at.rows[i]));
            }
            Eigen::Map<Row> ownRow(first);
            ownRow = x / at.value[0];
            continue;
        }
        const int rest = at.height - at.width;
        below.resize(static_cast<std::size_t>(rest) * R);
        for (int i = 0; i < rest; ++i) {
            const double* row = rowOf(at.rows[at.width + i]);
            for (int r = 0; r < R; ++r) {
                below[static_cast<std::size_t>(r) * rest + i] = row[r];
            }
        }
        for (int c = at.width - 1; c >= 0; --c) {
            const double* column = at.value + static_cast<std::ptrdiff_t>(c) * at.height;
            double* const own = first + static_cast<std::ptrdiff_t>(c) * R;
            Row x = Eigen::Map<Row>(own);
            const Eigen::Map<const Eigen::VectorXd> entry(column + at.width, rest);
            for (int r = 0; r < R; ++r) {
                x[r] -= entry.dot(Eigen::Map<const Eigen::VectorXd>(
                    below.data() + static_cast<std::ptrdiff_t>(r) * rest, rest));
            }
            for (int i = c + 1; i < at.width; ++i) {
                x -= column[i] * Eigen::Map<const Row>(first + static_cast<std::ptrdiff_t>(i) * R);
            }
            Eigen::Map<Row> ownRow(own);
            ownRow = x / column[c];
        }
    }
}

void FactorView::forward(Panel& X) const {
    constexpr std::array kSolve = {&FactorView::forwardFew<1>, &FactorView::forwardFew<2>,
                                   &FactorView::forwardFew<3>};
    solveFew(X, kSolve);
}

void FactorView::backward(Panel& X) const {
    constexpr std::array kSolve = {&FactorView::backwardFew<1>, &FactorView::backwardFew<2>,
                                   &FactorView::backwardFew<3>};
    solveFew(X, kSolve);
}

/// Solves for a few right-hand sides at a time.
void FactorView::solveFew(Panel& X, const std::array<Solve, kFew>& solve) const {
    if (X.cols() > 0 && X.cols() <= kFew) {
        (this->*solve[static_cast<std::size_t>(X.cols() - 1)])(X);
        return;
    }
    for (Eigen::Index done = 0; done < X.cols(); done += kFew) {
        const Eigen::Index count = std::min<Eigen::Index>(kFew, X.cols() - done);
        Panel few = X.middleCols(done, count);
        (this->*solve[static_cast<std::size_t>(count - 1)])(few);
        X.middleCols(done, count) = few;
    }
}

}  // namespace toile
