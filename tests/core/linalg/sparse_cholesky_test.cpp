// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A path's Laplacian with 2 + extra on the diagonal.
SymmetricMatrix pathMatrix(int size, double extra) {
    SymmetricBuilder builder(size);
    for (int i = 0; i < size; ++i) {
        builder.add(i, i, 2 + extra);
        if (i > 0) {
            builder.add(i - 1, i, -1);  // given above the diagonal, kept below
        }
    }
    return builder.build();
}

Eigen::MatrixXd dense(const SymmetricMatrix& matrix) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
    for (int j = 0; j < matrix.size; ++j) {
        for (int k = matrix.columnStart[j]; k < matrix.columnStart[j + 1]; ++k) {
            A(matrix.row[k], j) = A(j, matrix.row[k]) = matrix.value[k];
        }
    }
    return A;
}

TEST(SymmetricBuilder, SumsDuplicatesAndSortsColumns) {
    SymmetricBuilder builder(3);
    builder.add(2, 0, 1.5);
    builder.add(0, 2, 1.0);
    builder.add(1, 1, 4.0);
    builder.add(1, 0, -1.0);
    const SymmetricMatrix matrix = builder.build();
    EXPECT_EQ(matrix.columnStart, (std::vector<int>{0, 3, 4, 5}));
    EXPECT_EQ(matrix.row, (std::vector<int>{0, 1, 2, 1, 2}));
    EXPECT_EQ(matrix.value, (std::vector<double>{0.0, -1.0, 2.5, 4.0, 0.0}));
}

TEST(SparseCholesky, SolvesSeveralRightHandSidesAndAgain) {
    SparseCholesky cholesky;
    for (const int size : {1, 2, 50}) {
        const SymmetricMatrix A = pathMatrix(size, 0.1);
        ASSERT_TRUE(cholesky.factorise(A));
        const Eigen::MatrixXd X = Eigen::MatrixXd::Random(size, 2);
        const auto solved = cholesky.solve(dense(A) * X);
        ASSERT_TRUE(solved);
        EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(SparseCholesky, RefusesAnIndefiniteMatrix) {
    SparseCholesky cholesky;
    const auto result = cholesky.factorise(pathMatrix(30, -1.0));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::FactorisationFailed);
}

TEST(SparseCholesky, SolvesInAnyOrderOfElimination) {
    const SymmetricMatrix A = pathMatrix(40, 3.0);
    const Eigen::MatrixXd B = Eigen::MatrixXd::Random(40, 1);
    SparseCholesky plain, backwards;
    ASSERT_TRUE(plain.factorise(A));
    std::vector<int> order;
    for (int i = 39; i >= 0; --i) {
        order.push_back(i);
    }
    ASSERT_TRUE(backwards.analyse(A, order));
    ASSERT_TRUE(backwards.refactorise(A));
    EXPECT_LT((*plain.solve(B) - *backwards.solve(B)).norm(), 1e-12);
}

}  // namespace
}  // namespace toile
