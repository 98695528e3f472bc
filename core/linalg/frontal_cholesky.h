// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::linalg {

/// A kept Cholesky factorisation of a symmetric positive definite matrix, for many matrices of one
/// pattern and several threads: multifrontal ([DR83]) on CHOLMOD's supernodes. Branches of the tree
/// of fronts are eliminated side by side, and each front adds up what its children leave in their
/// order: the same bytes for any number of threads. Beside `SparseCholesky`, which is for few
/// factorisations of many matrices, it knows beforehand where each entry goes, and keeps its
/// memory. Not thread-safe. Side effect: as there.
class FrontalCholesky {
public:
    explicit FrontalCholesky(int threads = 1);
    ~FrontalCholesky();
    FrontalCholesky(FrontalCholesky&&) noexcept;
    FrontalCholesky& operator=(FrontalCholesky&&) noexcept;

    /// Lays out the factor; values are not looked at.
    /// @param order  the unknowns in the order of their elimination; empty: minimum degree
    /// Errors: OutOfMemory.
    Result<void> analyse(const SymmetricMatrix& pattern, const std::vector<int>& order = {});

    /// Factorises values in the pattern that was analysed. Errors: FactorisationFailed (not
    /// positive definite), OutOfMemory.
    Result<void> refactorise(const SymmetricMatrix& matrix);

    /// Precondition: refactorise succeeded. Errors: OutOfMemory.
    Result<Eigen::VectorXd> solve(const Eigen::VectorXd& right);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace toile::linalg
