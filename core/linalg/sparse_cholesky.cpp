// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cassert>
#include <utility>

#include "core/linalg/factor_state.h"

namespace toile {

std::optional<FactorView> SparseCholesky::State::view() const {
    return plain.factor != nullptr && FactorView::isReadable(*plain.factor)
               ? std::optional<FactorView>(*plain.factor)
               : std::nullopt;
}

SparseCholesky::SparseCholesky() : state_(std::make_unique<State>()) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Result<void> SparseCholesky::factorise(const SymmetricMatrix& matrix) {
    if (const auto analysed = analyse(matrix); !analysed) {
        return analysed;
    }
    return refactorise(matrix);
}

Result<void> SparseCholesky::analyse(const SymmetricMatrix& pattern) {
    return state_->plain.analyse(pattern);
}

Result<void> SparseCholesky::refactorise(const SymmetricMatrix& matrix) {
    assert(state_->plain.factor != nullptr);
    return state_->plain.factorise(matrix);
}

Result<Eigen::MatrixXd> SparseCholesky::solve(const Eigen::MatrixXd& B) {
    cholmod_common& common = state_->plain.common;
    assert(state_->plain.factor != nullptr);
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.nzmax = right.nrow * right.ncol;
    right.d = right.nrow;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->plain.factor, &right, &common);
    if (x == nullptr) {
        return Error{ErrorCode::OutOfMemory, "", "back-substitution"};
    }
    Eigen::MatrixXd X =
        Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), B.rows(), B.cols());
    cholmod_free_dense(&x, &common);
    return X;
}

std::size_t SparseCholesky::bytes() const {
    return state_->plain.bytes();
}

}  // namespace toile
