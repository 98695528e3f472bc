// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"

namespace toile {

/// One entry of an unsymmetric sparse matrix; entries at the same place are summed.
struct MatrixEntry {
    int row, column;
    double value;
};

/// A kept LU factorisation of a sparse unsymmetric matrix whose entries lie symmetrically, as those
/// of a weighted Laplacian with different weights to and fro. Minimum-degree ordering of rows and
/// columns alike; the diagonal is taken as pivot unless it is far smaller than its column. By
/// UMFPACK.
/// Thread-safety: one object per thread; separate objects are independent.
class SparseLu {
public:
    SparseLu();
    ~SparseLu();
    SparseLu(SparseLu&&) noexcept;
    SparseLu& operator=(SparseLu&&) noexcept;

    /// @param entries  of a size x size matrix
    /// Errors: FactorisationFailed (singular), OutOfMemory. Cost: one to four times a Cholesky
    /// factorisation of the same pattern.
    Result<void> factorise(int size, const std::vector<MatrixEntry>& entries);

    /// Solves for every column of B, with iterative refinement. Precondition: factorise succeeded.
    /// Errors: FactorisationFailed (nearly singular), OutOfMemory.
    Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& B) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace toile
