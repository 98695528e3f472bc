// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_lu.h"

#include <utility>

#include <umfpack.h>

#include "core/linalg/blas_call.h"

namespace toile::linalg {
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
