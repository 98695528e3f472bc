// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/dense_cholesky.h"

// Of LAPACK, which CHOLMOD uses as well: Eigen's own are compiled for any processor, and a quarter
// as fast.
extern "C" {
void dlauum_(const char* part, const int* n, double* A, const int* stride, int* failed);
void dpotrf_(const char* part, const int* n, double* A, const int* stride, int* failed);
}

namespace toile {

void squareUpper(DenseBlock& U) {
    const int n = static_cast<int>(U.rows());
    const int stride = static_cast<int>(U.outerStride());
    int failed = 0;  // nothing that can
    if (n > 0) {
        dlauum_("U", &n, U.data(), &stride, &failed);
    }
}

bool factoriseDense(Eigen::MatrixXd& A) {
    const int n = static_cast<int>(A.rows());
    int failed = 0;
    if (n > 0) {
        dpotrf_("L", &n, A.data(), &n, &failed);
    }
    return failed == 0;
}

}  // namespace toile
