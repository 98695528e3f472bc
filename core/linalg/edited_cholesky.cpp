// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/edited_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/linalg/factor_state.h"

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

/// Sparse columns carried through L.
struct Border {
    std::vector<int> column;  ///< place of each in the panel
    std::vector<int> reach;   ///< rows of L in which the panel is not zero
    FactorView::Panel panel;  ///< L^-1 of the columns, on the reach
};

/// Columns stand in the order in which they begin, so that those that meet early on their way up
/// stand together.
/// @param mostWork  in multiplications
Result<Border> carriedThrough(const FactorView& view, const std::vector<BorderEntry>& entries,
                              int width, double mostWork) {
    std::vector<int> begin(static_cast<std::size_t>(width), std::numeric_limits<int>::max());
    std::vector<int> rows;
    for (const BorderEntry& entry : entries) {
        begin[entry.column] = std::min(begin[entry.column], entry.row);
        rows.push_back(entry.row);
    }
    std::vector<int> order(begin.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&begin](int a, int b) { return begin[a] < begin[b]; });
    Border border;
    border.column.resize(order.size());
    for (int c = 0; c < width; ++c) {
        border.column[order[c]] = c;
    }
    FactorReach reach = view.reachOf(rows);
    const double work = (view.workOn(reach) + static_cast<double>(reach.columns.size()) * width) *
                        static_cast<double>(width);
    if (work > std::max(kFreeWork, mostWork)) {
        return unsuitable("the border would cost as much as a factorisation");
    }
    border.panel = FactorView::Panel::Zero(static_cast<Eigen::Index>(reach.columns.size()), width);
    for (const BorderEntry& entry : entries) {
        border.panel(reach.position[entry.row], border.column[entry.column]) += entry.value;
    }
    view.forwardOn(reach, border.panel);
    border.reach = std::move(reach.columns);
    return border;
}

/// P^T P.
Eigen::MatrixXd squareOf(const FactorView::Panel& panel) {
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(panel.cols(), panel.cols());
    if (panel.rows() == 0) {
        return G;  // Eigen divides by the number of rows
    }
    G.selfadjointView<Eigen::Lower>().rankUpdate(panel.transpose());
    G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
    return G;
}

/// Row of L of each unknown.
std::vector<int> rowsOf(const FactorView& view) {
    std::vector<int> rowOf(static_cast<std::size_t>(view.size()));
    for (int i = 0; i < view.size(); ++i) {
        rowOf[view.permutation()[i]] = i;
    }
    return rowOf;
}

}  // namespace

Result<EditedCholesky> EditedCholesky::make(std::shared_ptr<const SparseCholesky> factor,
                                            const MatrixEdit& edit) {
    const auto readable = factor->state_->view();
    if (!readable) {
        return unsuitable("this kind of factor cannot be shared");
    }
    const FactorView& view = *readable;
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

    const std::vector<int> rowOf = rowsOf(view);
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
    auto border = carriedThrough(view, entries, width, kMostWork * edited.factor_->state_->work());
    if (!border) {
        return border.error();
    }
    edited.column_ = std::move(border->column);
    edited.reach_ = std::move(border->reach);
    edited.border_ = std::move(border->panel);

    // The k equations.
    const Eigen::MatrixXd G = squareOf(edited.border_);
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

Eigen::MatrixXd EditedCholesky::borderUnknowns(const Eigen::MatrixXd& g,
                                               const Eigen::MatrixXd& addedRight) const {
    const std::size_t firstAdded = column_.size() - static_cast<std::size_t>(addedCount_);
    Eigen::MatrixXd h = g;
    for (std::size_t t = 0; t < touched_.size(); ++t) {
        h.row(column_[t]).setZero();
    }
    for (const auto& entry : changed_) {
        h.row(column_[entry.row]) += entry.value * g.row(column_[entry.column]);
    }
    for (int a = 0; a < addedCount_; ++a) {
        h.row(column_[firstAdded + a]) -= addedRight.row(a);
    }
    return small_.solve(h);
}

bool EditedCholesky::isCheap(double work) const {
    return work <= std::max(kFreeWork, kMostWork * factor_->state_->work());
}

Result<Eigen::MatrixXd> EditedCholesky::squareOnInverse(
    const std::vector<MatrixEdit::Entry>& columns, int width) const {
    const FactorView view = *factor_->state_->view();
    const std::vector<int> rowOf = rowsOf(view);
    if (width > kMostColumns) {
        return unsuitable("too many columns");
    }
    std::vector<BorderEntry> entries;
    Eigen::MatrixXd addedRight = Eigen::MatrixXd::Zero(addedCount_, width);
    for (const auto& entry : columns) {
        if (entry.row < oldSize_) {
            entries.push_back({rowOf[entry.row], entry.column, entry.value});
        } else {
            addedRight(entry.row - oldSize_, entry.column) += entry.value;
        }
    }
    auto carried = carriedThrough(view, entries, width, kMostWork * factor_->state_->work());
    if (!carried) {
        return carried.error();
    }
    const std::vector<int>& place = carried->column;
    Eigen::MatrixXd square = squareOf(carried->panel)(place, place);
    if (column_.empty()) {
        return square;
    }
    // Rows of L that both borders reach.
    std::vector<int> here;
    std::vector<int> there;
    for (std::size_t i = 0, j = 0; i < reach_.size() && j < carried->reach.size();) {
        const int difference = reach_[i] - carried->reach[j];
        if (difference == 0) {
            here.push_back(static_cast<int>(i));
            there.push_back(static_cast<int>(j));
        }
        i += difference <= 0 ? 1 : 0;
        j += difference >= 0 ? 1 : 0;
    }
    const Eigen::MatrixXd onBorder = border_(here, Eigen::all);
    const Eigen::MatrixXd panel = carried->panel(there, place);
    const Eigen::MatrixXd g = onBorder.transpose() * panel;
    const Eigen::MatrixXd z = borderUnknowns(g, addedRight);
    square.noalias() -= g.transpose() * z;
    const std::size_t firstAdded = column_.size() - static_cast<std::size_t>(addedCount_);
    for (int a = 0; a < addedCount_; ++a) {  // the added unknowns themselves
        square.noalias() += addedRight.row(a).transpose() * z.row(column_[firstAdded + a]);
    }
    return square;
}

Eigen::MatrixXd EditedCholesky::solve(const Eigen::MatrixXd& right) const {
    const FactorView view = *factor_->state_->view();
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
        z = borderUnknowns(g, right.bottomRows(addedCount_));
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
