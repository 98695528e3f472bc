// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cassert>
#include <string>

#include <cholmod.h>
#include <omp.h>

#ifdef __ELF__
// Present where OpenBLAS stands in for the BLAS; declared weak because it need not.
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));
#else
static void (*const openblas_set_num_threads)(int) = nullptr;
#endif

namespace toile {

/// CHOLMOD's workspace and the factor made with it.
struct SparseCholesky::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;

    State() {
        // CHOLMOD opens four OpenMP threads per large supernode, whatever the machine has. Pieces
        // are solved side by side already: no parallel regions inside, on this thread.
        omp_set_max_active_levels(0);
        // One BLAS thread for the same reason, and so that the same input gives the same bits.
        if (openblas_set_num_threads != nullptr) {
            openblas_set_num_threads(1);
        }
        cholmod_start(&common);
        common.print = 0;  // errors are values here, not text on a terminal
        common.error_handler = nullptr;
        // Minimum degree only: CHOLMOD would otherwise try METIS above a fill threshold, which
        // never pays for a single solve.
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        common.supernodal = CHOLMOD_AUTO;
        common.final_ll = 1;  // L L^T: an indefinite matrix is refused, not factorised
    }

    ~State() {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

SparseCholesky::SparseCholesky() : state_(std::make_unique<State>()) {}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

namespace {

Error failed(const std::string& why) {
    return Error{ErrorCode::FactorisationFailed, "", why};
}

Error outOfMemory(const std::string& during) {
    return Error{ErrorCode::OutOfMemory, "", during};
}

/// CHOLMOD's view of our arrays; it reads them and keeps nothing.
cholmod_sparse viewOf(const SymmetricMatrix& matrix) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
    view.nzmax = matrix.row.size();
    view.p = const_cast<int*>(matrix.columnStart.data());
    view.i = const_cast<int*>(matrix.row.data());
    view.x = const_cast<double*>(matrix.value.data());
    view.stype = -1;  // lower triangle stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

}  // namespace

Result<void> SparseCholesky::factorise(const SymmetricMatrix& matrix) {
    cholmod_common& common = state_->common;
    cholmod_free_factor(&state_->factor, &common);
    cholmod_sparse view = viewOf(matrix);
    state_->factor = cholmod_analyze(&view, &common);
    if (state_->factor == nullptr) {
        return outOfMemory("ordering");
    }
    return refactorise(matrix);
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

}  // namespace toile
