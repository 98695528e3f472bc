// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/nearby_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

// With C = B + W D W^T and d = W^T x: B x = b - W D d, so that (I + G D) d = W^T B^-1 b, where
// G = W^T B^-1 W. Where b = W t, the right side is G t.
namespace toile {
namespace {

/// Part of the change's size that is rounding: where taking it apart ends.
constexpr double kRounding = 1e-14;
/// What taking it apart may miss.
constexpr double kLeft = 1e-12;

Error unsuitableChange(const char* why) {
    return Error{ErrorCode::FactorisationFailed, "", why};
}

struct Columns {
    Eigen::MatrixXd W;        ///< rows in the order of `place`; unit lower trapezoidal
    Eigen::VectorXd weights;  ///< A = W diag(weights) W^T
    std::vector<int> place;   ///< of each row of W in A
    double left = 0;          ///< largest entry of what is left over
};

/// Cholesky's factorisation with pivots, stopped where nothing is left of a semidefinite matrix.
Columns takenApart(Eigen::MatrixXd A) {
    const double least = kRounding * A.cwiseAbs().maxCoeff();
    const Eigen::Index count = A.rows();
    Columns taken{Eigen::MatrixXd(count, count), Eigen::VectorXd(count), {}};
    std::vector<char> isPivot(static_cast<std::size_t>(count), 0);
    Eigen::Index rank = 0;
    for (; rank < count; ++rank) {
        Eigen::Index p = 0;
        const double pivot = A.diagonal().cwiseAbs().maxCoeff(&p);
        if (!(pivot > least)) {
            break;
        }
        taken.weights[rank] = A(p, p);
        taken.W.col(rank) = A.col(p) / A(p, p);
        taken.W(p, rank) = 1;
        A.noalias() -= taken.W.col(rank) * A.row(p).eval();
        A.row(p).setZero();
        A.col(p).setZero();
        isPivot[p] = 1;
        taken.place.push_back(static_cast<int>(p));
    }
    for (int i = 0; i < count; ++i) {
        if (isPivot[i] == 0) {
            taken.place.push_back(i);
        }
    }
    taken.W = Eigen::MatrixXd(taken.W(taken.place, Eigen::seqN(0, rank)));
    taken.weights.conservativeResize(rank);
    return taken;
}

}  // namespace

Result<NearbySolver> NearbySolver::make(std::shared_ptr<const EditedCholesky> edited,
                                        const std::vector<MatrixEdit::Entry>& changed) {
    NearbySolver solver;
    std::vector<int> rows;
    for (const auto& entry : changed) {
        rows.push_back(entry.row);
        rows.push_back(entry.column);
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    const auto count = static_cast<Eigen::Index>(rows.size());
    if (!edited->isCheap(std::pow(static_cast<double>(count), 3) / 6)) {
        return unsuitableChange("too many rows changed");
    }
    solver.edited_ = std::move(edited);
    if (count == 0) {
        return solver;
    }
    const auto indexOf = [&rows](int row) {
        return std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    };
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(count, count);
    for (const auto& entry : changed) {
        const auto i = indexOf(entry.row);
        const auto j = indexOf(entry.column);
        change(i, j) += entry.value;
        if (i != j) {
            change(j, i) += entry.value;
        }
    }
    Columns taken = takenApart(change);
    const double left = (taken.W * taken.weights.asDiagonal() * taken.W.transpose() -
                         change(taken.place, taken.place))
                            .cwiseAbs()
                            .maxCoeff();
    if (!(left <= kLeft * change.cwiseAbs().maxCoeff())) {
        return unsuitableChange("the change is not semidefinite");
    }
    solver.columns_ = std::move(taken.W);
    solver.weights_ = std::move(taken.weights);
    const Eigen::Index rank = solver.weights_.size();
    std::vector<MatrixEdit::Entry> columns;
    for (Eigen::Index i = 0; i < count; ++i) {
        solver.order_.push_back(rows[taken.place[i]]);
        for (Eigen::Index c = 0; c < std::min(i + 1, rank); ++c) {
            if (solver.columns_(i, c) != 0) {
                columns.push_back(
                    {solver.order_.back(), static_cast<int>(c), solver.columns_(i, c)});
            }
        }
    }
    auto square = solver.edited_->squareOnInverse(columns, static_cast<int>(rank));
    if (!square) {
        return square.error();
    }
    solver.square_ = std::move(*square);
    solver.small_.compute(Eigen::MatrixXd::Identity(rank, rank) +
                          solver.square_ * solver.weights_.asDiagonal());
    return solver;
}

Eigen::MatrixXd NearbySolver::solve(const Eigen::MatrixXd& right) const {
    return weights_.size() == 0
               ? edited_->solve(right)
               : solveKnowing(columns_.transpose() * edited_->solve(right)(order_, Eigen::all),
                              right);
}

Eigen::MatrixXd NearbySolver::solveChange(const Eigen::MatrixXd& right) const {
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(right.rows(), right.cols());
    if (weights_.size() == 0) {
        return rest;
    }
    const Eigen::Index rank = weights_.size();
    const Eigen::MatrixXd t = columns_.topRows(rank).triangularView<Eigen::UnitLower>().solve(
        right(order_, Eigen::all).topRows(rank));
    rest(order_, Eigen::all) = columns_ * t;
    return solveKnowing(square_ * t, std::move(rest));
}

/// @param before  W^T B^-1 right
Eigen::MatrixXd NearbySolver::solveKnowing(const Eigen::MatrixXd& before,
                                           Eigen::MatrixXd right) const {
    right(order_, Eigen::all) -= columns_ * (weights_.asDiagonal() * small_.solve(before));
    return edited_->solve(right);
}

}  // namespace toile
