// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/edited_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/linalg/cholmod_state.h"
#include "core/linalg/factor_view.h"

// With U = [E_touched, E_dropped, B_coupled] and w = U^T x, the edited system is
//   A x + U z = b,    s = D w_touched,    w_dropped = 0,    w_added + C y = b_added,
// where z = (s, forces on the dropped, y = the added unknowns) and D is the change. With
// g = U^T A^-1 b and G = U^T A^-1 U, w = g - G z, and k equations are left for z:
//   s + D (G z)_touched = D g_touched,   (G z)_dropped = g_dropped,
//   (G z)_added - C y = g_added - b_added.
namespace toile {
namespace {

/// Of a factorisation, in multiplications: beyond, a new one is cheaper.
constexpr double kMostWork = 0.5;
/// Small factorisations take their time in other things than multiplying.
constexpr double kFreeWork = 3e7;

struct BorderEntry {
    int row, column;
    double value;
};

Error unsuitable(const char* why) {
    return Error{ErrorCode::FactorisationFailed, "", why};
}

}  // namespace

Result<EditedCholesky> EditedCholesky::make(std::shared_ptr<const SparseCholesky> factor,
                                            const MatrixEdit& edit) {
    const cholmod_factor& L = *factor->state_->factor;
    if (!FactorView::isReadable(L)) {
        return unsuitable("this kind of factor cannot be shared");
    }
    const FactorView view(L);
    EditedCholesky edited;
    edited.oldSize_ = view.size();
    edited.addedCount_ = edit.addedCount;
    edited.dropped_ = edit.dropped;
    for (const auto& entry : edit.changed) {
        edited.touched_.push_back(entry.row);
        edited.touched_.push_back(entry.column);
    }
    std::vector<int>& touched = edited.touched_;
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    const auto indexOf = [&touched](int unknown) {
        return static_cast<int>(std::lower_bound(touched.begin(), touched.end(), unknown) -
                                touched.begin());
    };
    const std::size_t count = touched.size() + edit.dropped.size() + edit.addedCount;
    if (count > kMostColumns) {
        return unsuitable("too many rows changed");
    }
    edited.factor_ = std::move(factor);

    // The border, in rows of L. Columns stand in the order in which they begin, so that those that
    // meet early on their way up stand together.
    std::vector<int> rowOf(static_cast<std::size_t>(view.size()));
    for (int i = 0; i < view.size(); ++i) {
        rowOf[view.permutation()[i]] = i;
    }
    const int firstDropped = static_cast<int>(touched.size());
    const int firstAdded = firstDropped + static_cast<int>(edit.dropped.size());
    const int width = static_cast<int>(count);
    std::vector<BorderEntry> entries;
    for (int t = 0; t < firstDropped; ++t) {
        entries.push_back({rowOf[touched[t]], t, 1});
    }
    for (std::size_t d = 0; d < edit.dropped.size(); ++d) {
        entries.push_back({rowOf[edit.dropped[d]], firstDropped + static_cast<int>(d), 1});
    }
    for (const auto& entry : edit.coupled) {
        entries.push_back({rowOf[entry.row], firstAdded + entry.column, entry.value});
    }
    std::vector<int> begin(count, std::numeric_limits<int>::max());
    std::vector<int> rows;
    for (const BorderEntry& entry : entries) {
        begin[entry.column] = std::min(begin[entry.column], entry.row);
        rows.push_back(entry.row);
    }
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&begin](int a, int b) { return begin[a] < begin[b]; });
    edited.column_.resize(count);
    for (int c = 0; c < width; ++c) {
        edited.column_[order[c]] = c;
    }

    FactorReach reach = view.reachOf(rows);
    const double work = (view.workOn(reach) + static_cast<double>(reach.columns.size()) * width) *
                        static_cast<double>(width);
    if (work > std::max(kFreeWork, kMostWork * edited.factor_->state_->common.fl)) {
        return unsuitable("the border would cost as much as a factorisation");
    }
    edited.border_ = Panel::Zero(static_cast<Eigen::Index>(reach.columns.size()), width);
    for (const BorderEntry& entry : entries) {
        edited.border_(reach.position[entry.row], edited.column_[entry.column]) += entry.value;
    }
    view.forwardOn(reach, edited.border_);
    edited.reach_ = std::move(reach.columns);

    // The k equations.
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(width, width);
    G.selfadjointView<Eigen::Lower>().rankUpdate(edited.border_.transpose());
    G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
    Eigen::MatrixXd M = G;
    for (int t = 0; t < firstDropped; ++t) {
        M.row(edited.column_[t]).setZero();
        M(edited.column_[t], edited.column_[t]) = 1;
    }
    for (const auto& entry : edit.changed) {
        const int a = indexOf(entry.row);
        const int b = indexOf(entry.column);
        edited.changed_.push_back({a, b, entry.value});
        if (a != b) {
            edited.changed_.push_back({b, a, entry.value});
        }
    }
    for (const auto& entry : edited.changed_) {
        M.row(edited.column_[entry.row]) += entry.value * G.row(edited.column_[entry.column]);
    }
    for (const auto& entry : edit.amongAdded) {
        const int a = edited.column_[firstAdded + entry.row];
        const int b = edited.column_[firstAdded + entry.column];
        M(a, b) -= entry.value;
        if (a != b) {
            M(b, a) -= entry.value;
        }
    }
    if (width > 0) {
        edited.small_.compute(M);
    }
    return edited;
}

Eigen::MatrixXd EditedCholesky::solve(const Eigen::MatrixXd& right) const {
    const FactorView view(*factor_->state_->factor);
    const int* permutation = view.permutation();
    Panel X(oldSize_, right.cols());
    for (int i = 0; i < oldSize_; ++i) {
        X.row(i) = right.row(permutation[i]);
    }
    // What acts on a dropped unknown acts on nothing.
    view.forward(X);
    Eigen::MatrixXd z;
    if (!column_.empty()) {
        Panel onReach(static_cast<Eigen::Index>(reach_.size()), right.cols());
        for (std::size_t i = 0; i < reach_.size(); ++i) {
            onReach.row(static_cast<Eigen::Index>(i)) = X.row(reach_[i]);
        }
        const Eigen::MatrixXd g = border_.transpose() * onReach;
        const std::size_t firstAdded = column_.size() - static_cast<std::size_t>(addedCount_);
        Eigen::MatrixXd h = g;
        for (std::size_t t = 0; t < touched_.size(); ++t) {
            h.row(column_[t]).setZero();
        }
        for (const auto& entry : changed_) {
            h.row(column_[entry.row]) += entry.value * g.row(column_[entry.column]);
        }
        for (int a = 0; a < addedCount_; ++a) {
            h.row(column_[firstAdded + a]) -= right.row(oldSize_ + a);
        }
        z = small_.solve(h);
        onReach.noalias() -= border_ * z;
        for (std::size_t i = 0; i < reach_.size(); ++i) {
            X.row(reach_[i]) = onReach.row(static_cast<Eigen::Index>(i));
        }
    }
    view.backward(X);
    Eigen::MatrixXd solved(oldSize_ + addedCount_, right.cols());
    for (int i = 0; i < oldSize_; ++i) {
        solved.row(permutation[i]) = X.row(i);
    }
    const std::size_t firstAdded = column_.size() - static_cast<std::size_t>(addedCount_);
    for (int a = 0; a < addedCount_; ++a) {
        solved.row(oldSize_ + a) = z.row(column_[firstAdded + a]);
    }
    for (const int unknown : dropped_) {
        solved.row(unknown).setZero();
    }
    return solved;
}

}  // namespace toile
