// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/divided_factor.h"

#include <cstdlib>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include "core/base/thread_budget.h"
#include "core/linalg/edited_cholesky.h"
#include "core/linalg/elimination_order.h"
#include "tests/core/linalg/symmetric_product.h"

namespace toile {
namespace {

using test::times;

constexpr int kSide = 230;  // large enough to be divided

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
SymmetricMatrix laplacian(int size, const Couplings& edges, int seed = 1) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> weight(-0.1, 2);
    SymmetricBuilder builder(size);
    for (const auto& [i, j] : edges) {
        const double w = weight(random);
        builder.add(i, j, -w);
        builder.add(i, i, w + 0.2);
        builder.add(j, j, w + 0.2);
    }
    return builder.build();
}

SymmetricMatrix gridMatrix(int seed = 1) {
    return laplacian(kSide * kSide, gridEdges(kSide, kSide), seed);
}

/// Two unknowns to each vertex, coupled among each other and with those of neighbours.
SymmetricMatrix pairsMatrix() {
    SymmetricBuilder builder(2 * kSide * kSide);
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

bool isDivided(const SymmetricMatrix& A) {
    return DividedFactor::isWorthIt(eliminationOrder(A), A.size);
}

/// Adds to an entry on the diagonal.
void addAt(SymmetricMatrix& A, int unknown, double value) {
    A.value[A.columnStart[unknown]] += value;
}

void expectSolves(const SymmetricMatrix& A) {
    SparseCholesky divided, plain;
    ASSERT_TRUE(divided.factorise(A));
    ASSERT_TRUE(plain.analyse(A, eliminationOrder(A).order));  // an order from outside: not divided
    ASSERT_TRUE(plain.refactorise(A));
    for (const int columns : {1, 2, 5}) {
        const Eigen::MatrixXd X = Eigen::MatrixXd::Random(A.size, columns);
        const Eigen::MatrixXd right = times(A, X);
        const auto solved = divided.solve(right);
        ASSERT_TRUE(solved);
        EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LE((*solved - *plain.solve(right)).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(DividedFactor, SolvesAsThePlainFactorDoes) {
    const SymmetricMatrix A = gridMatrix();
    ASSERT_TRUE(isDivided(A));
    expectSolves(A);
}

TEST(DividedFactor, SolvesForPairsOfUnknowns) {
    const SymmetricMatrix A = pairsMatrix();
    ASSERT_TRUE(comesInPairs(A));
    ASSERT_TRUE(isDivided(A));
    expectSolves(A);
}

TEST(DividedFactor, SolvesOnGraphsThatFallApart) {
    // A ring: one level of distance cuts it in two places, and the halves in parts.
    Couplings ring = gridEdges(500, 110);
    for (int y = 0; y < 110; ++y) {
        ring.emplace_back(y * 500, y * 500 + 499);
    }
    expectSolves(laplacian(500 * 110, ring));
    // Two grids without a connection, and unknowns with none at all.
    Couplings both = gridEdges(170, 170);
    const Couplings second = gridEdges(150, 160, 170 * 170);
    both.insert(both.end(), second.begin(), second.end());
    SymmetricMatrix A = laplacian(170 * 170 + 150 * 160 + 20, both);
    for (int i = 170 * 170 + 150 * 160; i < A.size; ++i) {
        addAt(A, i, 1);
    }
    expectSolves(A);
}

TEST(DividedFactor, LeavesWhatCannotBeHalvedToThePlainFactor) {
    Couplings star;
    for (int i = 1; i < 60000; ++i) {
        star.emplace_back(0, i);
    }
    const SymmetricMatrix A = laplacian(60000, star);
    EXPECT_FALSE(isDivided(A));
    SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.factorise(A));
    const Eigen::MatrixXd X = Eigen::MatrixXd::Random(A.size, 1);
    EXPECT_LE((*cholesky.solve(times(A, X)) - X).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_FALSE(isDivided(laplacian(150 * 150, gridEdges(150, 150))));  // too small
}

TEST(DividedFactor, RefusesAnIndefiniteMatrixWhereverItIs) {
    const SymmetricMatrix A = gridMatrix();
    const EliminationOrder order = eliminationOrder(A);
    // In the first half, in the second, and in the separator.
    for (const int place : {5, order.halfEnd[0] + 5, order.halfEnd[1] + 5}) {
        SymmetricMatrix B = A;
        addAt(B, order.order[place], -100);
        SparseCholesky cholesky;
        const auto refused = cholesky.factorise(B);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::FactorisationFailed);
        ASSERT_TRUE(cholesky.refactorise(A));  // it goes on with others of the pattern
    }
    // Each half is positive definite, with the separator's entries; both together are not.
    SymmetricMatrix B = A;
    const int unknown = order.order[order.halfEnd[1] + 5];
    const double diagonal = B.value[B.columnStart[unknown]];
    double least = 0, most = diagonal;  // what can be taken from the entry
    SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.analyse(A));
    for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (least + most);
        B.value[B.columnStart[unknown]] = diagonal - middle;
        (cholesky.refactorise(B) ? least : most) = middle;
    }
    SparseCholesky plain;
    ASSERT_TRUE(plain.analyse(A, order.order));
    B.value[B.columnStart[unknown]] = diagonal - least;
    EXPECT_TRUE(plain.refactorise(B));
    B.value[B.columnStart[unknown]] = diagonal - 1.01 * most;
    EXPECT_FALSE(plain.refactorise(B));
}

TEST(DividedFactor, FactorisesOtherValuesOfThePattern) {
    SparseCholesky cholesky;
    ASSERT_TRUE(cholesky.analyse(gridMatrix()));
    for (const int seed : {2, 3}) {
        SymmetricMatrix A = gridMatrix(seed);
        const Eigen::MatrixXd X = Eigen::MatrixXd::Random(A.size, 2);
        const Eigen::MatrixXd right = times(A, X);
        ASSERT_TRUE(seed == 2 ? cholesky.refactorise(A) : cholesky.refactorise(std::move(A)));
        EXPECT_LE((*cholesky.solve(right) - X).cwiseAbs().maxCoeff(), 1e-12);
    }
    EXPECT_GT(cholesky.bytes(), sizeof(double) * kSide * kSide);
}

TEST(DividedFactor, GivesTheSameBytesOnOneThreadAndOnTwo) {
    const SymmetricMatrix A = gridMatrix();
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(A.size, 3);
    std::vector<Eigen::MatrixXd> solved;
    for (const int threads : {1, 2}) {
        const ThreadBudget::Worker worker(std::make_shared<ThreadBudget>(threads));
        SparseCholesky cholesky;
        ASSERT_TRUE(cholesky.factorise(A));
        solved.push_back(*cholesky.solve(right));
    }
    EXPECT_TRUE(solved[0] == solved[1]);
}

TEST(DividedFactor, CarriesEdits) {
    const SymmetricMatrix A = gridMatrix();
    const auto factor = std::make_shared<SparseCholesky>();
    ASSERT_TRUE(factor->factorise(A));
    const EliminationOrder order = eliminationOrder(A);
    const auto unknownAt = [&order](int place) -> int { return order.order[place]; };
    // In both halves and in the separator, each and between them.
    const int inFirst = unknownAt(1000), inSecond = unknownAt(order.halfEnd[0] + 1000);
    const int between = unknownAt(order.halfEnd[1] + 20);
    MatrixEdit edit;
    edit.dropped = {unknownAt(order.halfEnd[1] + 100), unknownAt(2000)};
    edit.changed = {{inFirst, between, -0.5},
                    {inFirst, inFirst, 0.6},
                    {between, between, 0.7},
                    {inFirst, inSecond, -0.4},
                    {inSecond, inSecond, 0.9}};
    edit.addedCount = 1;
    edit.amongAdded = {{0, 0, 3}};
    edit.coupled = {{inSecond, 0, -1}, {between, 0, -0.8}};
    SymmetricBuilder builder(A.size + 1);
    const auto isDropped = [&edit](int i) -> bool {
        return i == edit.dropped[0] || i == edit.dropped[1];
    };
    for (int j = 0; j < A.size; ++j) {
        for (int k = A.columnStart[j]; k < A.columnStart[j + 1]; ++k) {
            if (!isDropped(j) && !isDropped(A.row[k])) {
                builder.add(A.row[k], j, A.value[k]);
            }
        }
    }
    for (const auto& entry : edit.changed) {
        builder.add(entry.row, entry.column, entry.value);
    }
    builder.add(A.size, A.size, 3);
    for (const auto& entry : edit.coupled) {
        builder.add(entry.row, A.size, entry.value);
    }
    const SymmetricMatrix B = builder.build();
    const auto edited = EditedCholesky::make(factor, edit);
    ASSERT_TRUE(edited);
    Eigen::MatrixXd X = Eigen::MatrixXd::Random(B.size, 2);
    for (const int unknown : edit.dropped) {
        X.row(unknown).setZero();
    }
    EXPECT_LE((edited->solve(times(B, X)) - X).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(DividedFactor, SaysWhereThereIsNoMemory) {
    const SymmetricMatrix A = gridMatrix();
    SparseCholesky cholesky;
    void* (*const allocate)(std::size_t) = SuiteSparse_config.malloc_func;
    SuiteSparse_config.malloc_func = [](std::size_t size) -> void* {
        return size < 1000000 ? std::malloc(size) : nullptr;
    };
    const auto analysed = cholesky.analyse(A);
    SuiteSparse_config.malloc_func = allocate;
    if (!analysed) {
        EXPECT_EQ(analysed.error().code, ErrorCode::OutOfMemory);
    }
    ASSERT_TRUE(cholesky.analyse(A));
    SuiteSparse_config.malloc_func = [](std::size_t size) -> void* {
        return size < 1000000 ? std::malloc(size) : nullptr;
    };
    const auto factorised = cholesky.refactorise(A);
    SuiteSparse_config.malloc_func = allocate;
    ASSERT_FALSE(factorised);
    EXPECT_EQ(factorised.error().code, ErrorCode::OutOfMemory);
    ASSERT_TRUE(cholesky.refactorise(A));
}

}  // namespace
}  // namespace toile
