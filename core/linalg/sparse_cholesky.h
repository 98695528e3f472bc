// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <Eigen/SparseCore>

#include "core/base/result.h"

namespace toile::linalg {

/// Lower triangle of a sparse symmetric matrix, column by column, rows ascending, the diagonal
/// entry first in each column and always present.
struct SymmetricMatrix {
    int size = 0;
    std::vector<int> columnStart;  ///< size + 1
    std::vector<int> row;
    std::vector<double> value;
};

/// Collects entries (duplicates are summed) into a SymmetricMatrix. Entries above the diagonal are
/// mirrored; add each off-diagonal pair once. Cost: linear.
class SymmetricBuilder {
public:
    explicit SymmetricBuilder(int size) : size_(size) {
        for (int i = 0; i < size; ++i) {
            add(i, i, 0);  // always present
        }
    }

    void reserve(std::size_t entries) { entries_.reserve(entries); }
    void add(int i, int j, double value) {
        entries_.emplace_back(std::max(i, j), std::min(i, j), value);
    }
    SymmetricMatrix build() const;

private:
    int size_;
    std::vector<Eigen::Triplet<double>> entries_;
};

/// A stored Cholesky factorisation of a symmetric positive definite matrix (CHOLMOD: simplicial for
/// small systems, supernodal for large ones). `factorise` does everything; `analyse` and
/// `refactorise` are its two halves, for several matrices of one pattern and to check the caller's
/// progress in between. Thread-safety: any number of threads may `solve`, only one factorise;
/// separate objects are independent. Side effect: OpenMP regions on the calling thread, and
/// OpenBLAS, use one thread from then on.
class SparseCholesky {
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Errors: FactorisationFailed (not positive definite), OutOfMemory.
    Result<void> factorise(const SymmetricMatrix& matrix);

    /// Orders the unknowns by minimum degree [ADD04] and plans the factor; values are not read.
    /// @param order  the unknowns in elimination order, if a better one is known
    /// Errors: OutOfMemory. Cost: a fifth to a third of a factorisation.
    Result<void> analyse(const SymmetricMatrix& pattern, std::vector<int> order = {});

    /// Factorises values in the pattern last given to `analyse` or `factorise`.
    /// Precondition: one of them was called with this pattern, without OutOfMemory.
    /// Errors: as `factorise`.
    Result<void> refactorise(const SymmetricMatrix& matrix);

    /// Solves for every column of B at once. Precondition: factorise succeeded.
    /// Errors: OutOfMemory.
    Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& B) const;

    /// Approximate memory of the factor.
    std::size_t bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Solves A X = B for a sparse matrix with unsymmetric values at symmetric positions, such as a
/// weighted Laplacian with a different weight per direction: an LU factorisation by UMFPACK, with
/// iterative refinement. Minimum-degree ordering of rows and columns alike; the diagonal is the
/// pivot unless it is far smaller than its column.
/// @param entries  of A, as many rows as B; entries at the same position are summed
/// Errors: FactorisationFailed (singular, or nearly so), OutOfMemory. Cost: one to four times a
/// Cholesky factorisation of the same pattern. Re-entrant.
Result<Eigen::MatrixXd> solveUnsymmetric(const std::vector<Eigen::Triplet<double>>& entries,
                                         const Eigen::MatrixXd& B);

}  // namespace toile::linalg
