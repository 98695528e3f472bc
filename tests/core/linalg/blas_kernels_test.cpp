// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/blas_kernels.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "core/linalg/sparse_cholesky.h"

namespace toile {
namespace {

/// Every unknown coupled with every other, so that the factor is one dense block.
SymmetricMatrix denseSystem(int size) {
    SymmetricBuilder builder(size);
    for (int i = 0; i < size; ++i) {
        builder.add(i, i, size + 1.0);
        for (int j = 0; j < i; ++j) {
            builder.add(i, j, -1);
        }
    }
    return builder.build();
}

double largestError(int size) {
    // Rows sum to 2, so that the solution for twos is ones.
    const SymmetricMatrix A = denseSystem(size);
    SparseCholesky cholesky;
    EXPECT_TRUE(cholesky.factorise(A));
    const auto solved = cholesky.solve(Eigen::MatrixXd::Constant(size, 1, 2));
    EXPECT_TRUE(solved);
    return (solved->array() - 1).abs().maxCoeff();
}

TEST(BlasKernels, SolveAsWellAfterTheChoiceAsBefore) {
    const char* const chosen = std::getenv("OPENBLAS_CORETYPE");
    EXPECT_LT(largestError(300), 1e-12);
    chooseBlasKernels();
    EXPECT_LT(largestError(300), 1e-12);
    chooseBlasKernels();
    EXPECT_LT(largestError(300), 1e-12);
    EXPECT_STREQ(std::getenv("OPENBLAS_CORETYPE"), chosen);
}

}  // namespace
}  // namespace toile
