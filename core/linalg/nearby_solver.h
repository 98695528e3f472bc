// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "core/base/result.h"
#include "core/linalg/edited_cholesky.h"

namespace toile {

/// Solves with a matrix C that differs in a few rows from an edited one, B, by a semidefinite
/// change: an edit on top of another, whose border is not carried through the factor once more. The
/// change is taken apart into as many columns as its rank, which may be far below the number of its
/// rows. Immutable: any number of threads may solve with it. Shares the edited matrix.
class NearbySolver {
public:
    /// @param changed  C - B between unknowns of B that are not dropped, numbered as the rows of
    ///                 `EditedCholesky::solve`; each pair once, either way
    /// Errors: FactorisationFailed, as `EditedCholesky::make`, and where the change cannot be taken
    /// apart, as may be if it is not semidefinite. Cost: that of its rank in columns, and r^3 for r
    /// changed rows.
    static Result<NearbySolver> make(std::shared_ptr<const EditedCholesky> edited,
                                     const std::vector<MatrixEdit::Entry>& changed);

    /// C X = right for every column, rows as in `EditedCholesky::solve`. Not refined. Cost: two
    /// solves with the edited matrix.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

    /// The same for a right side that is C - B times something, as what a solution with B leaves of
    /// an equation with C is: rows that did not change are not looked at. Cost: one solve.
    Eigen::MatrixXd solveChange(const Eigen::MatrixXd& right) const;

private:
    NearbySolver() = default;

    Eigen::MatrixXd solveKnowing(const Eigen::MatrixXd& before, Eigen::MatrixXd right) const;

    // C - B = W diag(weights) W^T.
    std::shared_ptr<const EditedCholesky> edited_;
    Eigen::MatrixXd columns_;  ///< W, unit lower trapezoidal
    std::vector<int> order_;   ///< row of the matrix of each row of `columns_`
    Eigen::VectorXd weights_;  ///< diag
    Eigen::MatrixXd square_;   ///< W^T B^-1 W
    Eigen::PartialPivLU<Eigen::MatrixXd> small_;
};

}  // namespace toile
