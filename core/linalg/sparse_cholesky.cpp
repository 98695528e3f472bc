// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cassert>
#include <string>

#include "core/linalg/cholmod_state.h"
#include "core/linalg/elimination_order.h"

namespace toile {

SparseCholesky::SparseCholesky() : state_(std::make_unique<State>()) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

namespace {

/// Supernodes for factors with this many operations per entry: below, the bookkeeping costs more
/// than dense blocks gain. Unknowns in pairs fill such blocks sooner.
constexpr double kSupernodes = 70;
constexpr double kSupernodesInPairs = 40;

Error failed(const std::string& why) {
    return Error{ErrorCode::FactorisationFailed, "", why};
}

Error outOfMemory(const std::string& during) {
    return Error{ErrorCode::OutOfMemory, "", during};
}

}  // namespace

Result<void> SparseCholesky::factorise(const SymmetricMatrix& matrix) {
    if (const auto analysed = analyse(matrix); !analysed) {
        return analysed;
    }
    return refactorise(matrix);
}

Result<void> SparseCholesky::analyse(const SymmetricMatrix& pattern, std::vector<int> order) {
    cholmod_common& common = state_->common;
    cholmod_free_factor(&state_->factor, &common);
    if (order.empty()) {
        order = eliminationOrder(pattern);
    }
    common.supernodal_switch = comesInPairs(pattern) ? kSupernodesInPairs : kSupernodes;
    cholmod_sparse view = viewOf(pattern);
    common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
    state_->factor = order.empty() ? cholmod_analyze(&view, &common)
                                   : cholmod_analyze_p(&view, order.data(), nullptr, 0, &common);
    if (state_->factor == nullptr) {
        return outOfMemory("ordering");
    }
    return {};
}

Result<void> SparseCholesky::refactorise(const SymmetricMatrix& matrix) {
    assert(state_->factor != nullptr);
    cholmod_common& common = state_->common;
    cholmod_sparse view = viewOf(matrix);
    cholmod_factorize(&view, state_->factor, &common);
    if (common.status == CHOLMOD_NOT_POSDEF ||
        state_->factor->minor < static_cast<std::size_t>(matrix.size)) {
        return failed("the matrix is not positive definite");
    }
    if (common.status < CHOLMOD_OK) {
        return outOfMemory("factorising");
    }
    return {};
}

Result<Eigen::MatrixXd> SparseCholesky::solve(const Eigen::MatrixXd& B) {
    assert(state_->factor != nullptr);
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(B.rows());
    right.ncol = static_cast<std::size_t>(B.cols());
    right.nzmax = right.nrow * right.ncol;
    right.d = right.nrow;
    right.x = const_cast<double*>(B.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, state_->factor, &right, &state_->common);
    if (x == nullptr) {
        return outOfMemory("back-substitution");
    }
    Eigen::MatrixXd X =
        Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), B.rows(), B.cols());
    cholmod_free_dense(&x, &state_->common);
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

}  // namespace toile
