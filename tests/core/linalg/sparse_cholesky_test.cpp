// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_cholesky.h"

#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include "tests/core/linalg/symmetric_product.h"

namespace toile {
namespace {

/// A path's Laplacian with 2 + extra on the diagonal.
linalg::SymmetricMatrix pathMatrix(int size, double extra) {
    linalg::SymmetricBuilder builder(size);
    for (int i = 0; i < size; ++i) {
        builder.add(i, i, 2 + extra);
        if (i > 0) {
            builder.add(i - 1, i, -1);  // given above the diagonal, kept below
        }
    }
    return builder.build();
}

Eigen::MatrixXd denseOf(const linalg::SymmetricMatrix& matrix) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
    for (int j = 0; j < matrix.size; ++j) {
        for (int k = matrix.columnStart[j]; k < matrix.columnStart[j + 1]; ++k) {
            A(matrix.row[k], j) = A(j, matrix.row[k]) = matrix.value[k];
        }
    }
    return A;
}

using Couplings = std::vector<std::pair<int, int>>;

Couplings gridEdges(int width, int height, int first = 0) {
    Couplings edges;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int i = first + y * width + x;
            if (x + 1 < width) {
                edges.emplace_back(i, i + 1);
            }
            if (y + 1 < height) {
                edges.emplace_back(i, i + width);
            }
        }
    }
    return edges;
}

/// A Laplacian with random weights, some of them negative, and a little on the diagonal.
linalg::SymmetricMatrix laplacian(int size, const Couplings& edges, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(-0.1, 2);
    linalg::SymmetricBuilder builder(size);
    for (int i = 0; i < size; ++i) {
        builder.add(i, i, 0.1);
    }
    for (const auto& [i, j] : edges) {
        const double w = weight(random);
        builder.add(i, j, -w);
        builder.add(i, i, w + 0.2);
        builder.add(j, j, w + 0.2);
    }
    return builder.build();
}

constexpr int kSide = 230;  // large enough for supernodes

linalg::SymmetricMatrix gridMatrix(unsigned seed = 1) {
    return laplacian(kSide * kSide, gridEdges(kSide, kSide), seed);
}

/// Two unknowns to each vertex, coupled among each other and with those of neighbours.
linalg::SymmetricMatrix pairsMatrix() {
    linalg::SymmetricBuilder builder(2 * kSide * kSide);
    for (int v = 0; v < kSide * kSide; ++v) {
        builder.add(2 * v, 2 * v + 1, 0.3);
        builder.add(2 * v, 2 * v, 0.5);
        builder.add(2 * v + 1, 2 * v + 1, 0.5);
    }
    for (const auto& [i, j] : gridEdges(kSide, kSide)) {
        for (const int a : {0, 1}) {
            for (const int b : {0, 1}) {
                builder.add(2 * i + a, 2 * j + b, a == b ? -1 : 0.2);
            }
            builder.add(2 * i + a, 2 * i + a, 1.3);
            builder.add(2 * j + a, 2 * j + a, 1.3);
        }
    }
    return builder.build();
}

void expectSolves(linalg::SparseCholesky& cholesky, const linalg::SymmetricMatrix& A,
                  double accuracy) {
    for (const int columns : {1, 2, 5}) {
        const Eigen::MatrixXd X = Eigen::MatrixXd::Random(A.size, columns);
        const auto solved = cholesky.solve(test::times(A, X));
        ASSERT_TRUE(solved);
        EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), accuracy);
    }
}

void expectFactorises(const linalg::SymmetricMatrix& A, double accuracy = 1e-12) {
    linalg::SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.factorise(A));
    expectSolves(cholesky, A, accuracy);
}

TEST(SymmetricBuilder, SumsDuplicatesAndSortsColumns) {
    linalg::SymmetricBuilder builder(3);
    builder.add(2, 0, 1.5);
    builder.add(0, 2, 1.0);
    builder.add(1, 1, 4.0);
    builder.add(1, 0, -1.0);
    const linalg::SymmetricMatrix matrix = builder.build();
    EXPECT_EQ(matrix.columnStart, (std::vector<int>{0, 3, 4, 5}));
    EXPECT_EQ(matrix.row, (std::vector<int>{0, 1, 2, 1, 2}));
    EXPECT_EQ(matrix.value, (std::vector<double>{0.0, -1.0, 2.5, 4.0, 0.0}));
}

TEST(SparseCholesky, SolvesSeveralRightHandSidesAndAgain) {
    linalg::SparseCholesky cholesky;
    for (const int size : {1, 2, 50}) {
        const linalg::SymmetricMatrix A = pathMatrix(size, 0.1);
        ASSERT_TRUE(cholesky.factorise(A));
        const Eigen::MatrixXd X = Eigen::MatrixXd::Random(size, 2);
        const auto solved = cholesky.solve(denseOf(A) * X);
        ASSERT_TRUE(solved);
        EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(SparseCholesky, RefusesAnIndefiniteMatrix) {
    linalg::SparseCholesky cholesky;
    const auto result = cholesky.factorise(pathMatrix(30, -1.0));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::FactorisationFailed);
}

TEST(SparseCholesky, SolvesLargeSystems) {
    expectFactorises(gridMatrix());
    expectFactorises(pairsMatrix());
}

TEST(SparseCholesky, SolvesOnGraphsThatFallApart) {
    Couplings ring = gridEdges(500, 110);
    for (int y = 0; y < 110; ++y) {
        ring.emplace_back(y * 500, y * 500 + 499);
    }
    expectFactorises(laplacian(500 * 110, ring));
    // Two grids without a connection, and unknowns with none at all.
    Couplings both = gridEdges(170, 170);
    const Couplings second = gridEdges(150, 160, 170 * 170);
    both.insert(both.end(), second.begin(), second.end());
    expectFactorises(laplacian(170 * 170 + 150 * 160 + 20, both));
    Couplings star;
    for (int i = 1; i < 60000; ++i) {
        star.emplace_back(0, i);
    }
    expectFactorises(laplacian(60000, star), 1e-10);
}

TEST(SparseCholesky, FactorisesOtherValuesOfThePattern) {
    linalg::SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.analyse(gridMatrix()));
    for (const unsigned seed : {2U, 3U}) {
        const linalg::SymmetricMatrix A = gridMatrix(seed);
        ASSERT_TRUE(cholesky.refactorise(A));
        expectSolves(cholesky, A, 1e-12);
    }
    EXPECT_GT(cholesky.bytes(), sizeof(double) * kSide * kSide);
}

TEST(SparseCholesky, GoesOnAfterAnIndefiniteMatrixOfItsPattern) {
    const linalg::SymmetricMatrix A = gridMatrix();
    linalg::SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.analyse(A));
    for (const int unknown : {5, A.size / 2, A.size - 1}) {
        linalg::SymmetricMatrix B = A;
        B.value[B.columnStart[unknown]] -= 100;
        const auto refused = cholesky.refactorise(B);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::FactorisationFailed);
        ASSERT_TRUE(cholesky.refactorise(A));
        expectSolves(cholesky, A, 1e-12);
    }
}

TEST(SparseCholesky, SaysWhereThereIsNoMemory) {
    const linalg::SymmetricMatrix A = gridMatrix();
    linalg::SparseCholesky cholesky;
    void* (*const allocate)(std::size_t) = SuiteSparse_config.malloc_func;
    const auto scarce = [](std::size_t size) -> void* {
        return size < 1000000 ? std::malloc(size) : nullptr;
    };
    SuiteSparse_config.malloc_func = scarce;
    const auto analysed = cholesky.analyse(A);
    SuiteSparse_config.malloc_func = allocate;
    if (!analysed) {
        EXPECT_EQ(analysed.error().code, ErrorCode::OutOfMemory);
    }
    ASSERT_TRUE(cholesky.analyse(A));
    SuiteSparse_config.malloc_func = scarce;
    const auto factorised = cholesky.refactorise(A);
    SuiteSparse_config.malloc_func = allocate;
    ASSERT_FALSE(factorised);
    EXPECT_EQ(factorised.error().code, ErrorCode::OutOfMemory);
    ASSERT_TRUE(cholesky.refactorise(A));
}

}  // namespace
}  // namespace toile
