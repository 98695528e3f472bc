// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the BLAS and LAPACK that CHOLMOD calls, what we call ourselves. Matrices lie column by column;
// call them within a `BlasCall`.
// NOLINTBEGIN(readability-identifier-naming): Fortran names them
extern "C" {
/// Lower Cholesky factor in place; info > 0: not positive definite.
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
/// B := alpha B op(A)^-1 or alpha op(A)^-1 B.
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b,
            const int* ldb);
/// C := alpha A A^T + beta C, one triangle of it.
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* beta, double* c, const int* ldc);
/// x := op(A)^-1 x.
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a,
            const int* lda, double* x, const int* incx);
/// y := alpha op(A) x + beta y.
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta, double* y,
            const int* incy);
}
// NOLINTEND(readability-identifier-naming)
