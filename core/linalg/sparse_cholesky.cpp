// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cassert>
#include <utility>

#include <umfpack.h>

#include "core/linalg/blas_call.h"
#include "core/linalg/cholmod_workspace.h"

namespace toile::linalg {

SymmetricMatrix SymmetricBuilder::build() const {
    Eigen::SparseMatrix<double> sum(size_, size_);
    sum.setFromTriplets(entries_.begin(), entries_.end());
    const int* const start = sum.outerIndexPtr();
    const int* const row = sum.innerIndexPtr();
    const double* const value = sum.valuePtr();
    return {size_,
            {start, start + size_ + 1},
            {row, row + sum.nonZeros()},
            {value, value + sum.nonZeros()}};
}

struct SparseCholesky::State {
    CholmodWorkspace workspace;
    cholmod_factor* factor = nullptr;

    State() = default;
    ~State() { cholmod_free_factor(&factor, &workspace.common); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

SparseCholesky::SparseCholesky() : state_(std::make_unique<State>()) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Result<void> SparseCholesky::factorise(const SymmetricMatrix& matrix) {
    if (auto analysed = analyse(matrix); !analysed) {
        return analysed;
    }
    return refactorise(matrix);
}

Result<void> SparseCholesky::analyse(const SymmetricMatrix& pattern, std::vector<int> order) {
    cholmod_common& common = state_->workspace.common;
    cholmod_free_factor(&state_->factor, &common);
    cholmod_sparse view = cholmodView(pattern);
    common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
    state_->factor =
        cholmod_analyze_p(&view, order.empty() ? nullptr : order.data(), nullptr, 0, &common);
    if (state_->factor == nullptr) {
        return Error{ErrorCode::OutOfMemory, {}, "ordering"};
    }
    return {};
}

Result<void> SparseCholesky::refactorise(const SymmetricMatrix& matrix) {
    assert(state_->factor != nullptr);
    cholmod_common& common = state_->workspace.common;
    const BlasCall blas;
    if (state_->factor->is_super != 0 && blas.room() == 0) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    if (state_->factor->is_super != 0 && state_->factor->xtype == CHOLMOD_PATTERN) {
        cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, state_->factor, &common);
        useLargePages(static_cast<double*>(state_->factor->x), state_->factor->xsize);
    }
    cholmod_sparse view = cholmodView(matrix);
    cholmod_factorize(&view, state_->factor, &common);
    if (common.status == CHOLMOD_NOT_POSDEF || state_->factor->minor < state_->factor->n) {
        return Error{ErrorCode::FactorisationFailed, {}, "the matrix is not positive definite"};
    }
    if (common.status < CHOLMOD_OK) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return {};
}

Result<Eigen::MatrixXd> SparseCholesky::solve(const Eigen::MatrixXd& B) const {
    assert(state_->factor != nullptr);
    const BlasCall blas;
    if (state_->factor->is_super != 0 && blas.room() == 0) {
        return Error{ErrorCode::OutOfMemory, {}, "back-substitution"};
    }
    CholmodWorkspace workspace;  // a local one: several threads may solve at a time
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.nzmax = right.nrow * right.ncol;
    right.d = right.nrow;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->factor, &right, &workspace.common);
    if (x == nullptr) {
        return Error{ErrorCode::OutOfMemory, {}, "back-substitution"};
    }
    Eigen::MatrixXd X =
        Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), B.rows(), B.cols());
    cholmod_free_dense(&x, &workspace.common);
    return X;
}

std::size_t SparseCholesky::bytes() const {
    const cholmod_factor* factor = state_->factor;
    if (factor == nullptr) {
        return 0;
    }
    const std::size_t entries = factor->is_super != 0
                                    ? sizeof(double) * factor->xsize + sizeof(int) * factor->ssize
                                    : (sizeof(double) + sizeof(int)) * factor->nzmax;
    return entries + 4 * sizeof(int) * factor->n;
}

namespace {

/// UMFPACK's objects of one factorisation.
struct Factors {
    void* symbolic = nullptr;
    void* numeric = nullptr;

    Factors() = default;
    ~Factors() {
        umfpack_di_free_symbolic(&symbolic);
        umfpack_di_free_numeric(&numeric);
    }
    Factors(const Factors&) = delete;
    Factors& operator=(const Factors&) = delete;
};

Error failureOf(int status) {
    if (status == UMFPACK_ERROR_out_of_memory) {
        return Error{ErrorCode::OutOfMemory, {}, "factorising"};
    }
    return Error{ErrorCode::FactorisationFailed, {}, "the matrix is singular"};
}

}  // namespace

Result<Eigen::MatrixXd> solveUnsymmetric(const std::vector<Eigen::Triplet<double>>& entries,
                                         const Eigen::MatrixXd& B) {
    const BlasCall blas;
    if (blas.room() == 0) {
        return failureOf(UMFPACK_ERROR_out_of_memory);
    }
    Eigen::SparseMatrix<double> A(B.rows(), B.rows());
    A.setFromTriplets(entries.begin(), entries.end());
    const int* const start = A.outerIndexPtr();
    const int* const row = A.innerIndexPtr();
    const auto size = static_cast<int>(B.rows());
    double control[UMFPACK_CONTROL];
    umfpack_di_defaults(control);
    // By default UMFPACK may take an asymmetric pattern of nearly symmetric values for unsymmetric,
    // and order by columns only.
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    Factors factors;
    int status = umfpack_di_symbolic(size, size, start, row, A.valuePtr(), &factors.symbolic,
                                     control, nullptr);
    if (status == UMFPACK_OK) {
        status = umfpack_di_numeric(start, row, A.valuePtr(), factors.symbolic, &factors.numeric,
                                    control, nullptr);
    }
    Eigen::MatrixXd X(B.rows(), B.cols());
    for (Eigen::Index k = 0; k < B.cols() && status == UMFPACK_OK; ++k) {
        status = umfpack_di_solve(UMFPACK_A, start, row, A.valuePtr(), X.col(k).data(),
                                  B.col(k).data(), factors.numeric, nullptr, nullptr);
    }
    return status == UMFPACK_OK ? Result<Eigen::MatrixXd>(std::move(X)) : failureOf(status);
}

}  // namespace toile::linalg
