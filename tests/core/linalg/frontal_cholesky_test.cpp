// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/frontal_cholesky.h"

#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#ifdef __linux__
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>
#endif

#include "core/linalg/elimination_order.h"
#include "tests/core/linalg/symmetric_product.h"

namespace toile {
namespace {

/// Three unknowns to each vertex of a grid, all of which act on those of its neighbours, with
/// random weights. Several grids side by side do not act on each other.
linalg::SymmetricMatrix gridOfBlocks(int side, unsigned seed, int grids = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(-1, 1);
    const int each = side * side;
    linalg::SymmetricBuilder builder(3 * each * grids);
    const auto couple = [&](int v, int w) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                builder.add(3 * v + i, 3 * w + j, weight(random));
            }
        }
    };
    for (int v = 0; v < each * grids; ++v) {
        const int x = v % side, y = v % each / side;
        for (int i = 0; i < 3; ++i) {
            builder.add(3 * v + i, 3 * v + i, 14);  // more than a row of weights
        }
        if (x + 1 < side) {
            couple(v, v + 1);
        }
        if (y + 1 < side) {
            couple(v, v + side);
        }
    }
    return builder.build();
}

Eigen::VectorXd someRight(int size) {
    return Eigen::VectorXd::LinSpaced(size, -3, 5).array().sin();
}

Eigen::VectorXd solved(linalg::FrontalCholesky& factor, const linalg::SymmetricMatrix& matrix) {
    EXPECT_TRUE(factor.refactorise(matrix));
    const auto x = factor.solve(someRight(matrix.size));
    return x ? *x : Eigen::VectorXd();
}

double residual(const linalg::SymmetricMatrix& matrix, const Eigen::VectorXd& x) {
    return (test::times(matrix, x) - someRight(matrix.size)).cwiseAbs().maxCoeff();
}

TEST(FrontalCholesky, SolvesAnySizeInAnyOrder) {
    for (const int side : {1, 2, 7, 40}) {
        for (const int grids : {1, 3}) {
            const auto matrix = gridOfBlocks(side, 1, grids);
            for (const bool isDissected : {false, true}) {
                linalg::FrontalCholesky factor;
                ASSERT_TRUE(factor.analyse(
                    matrix, isDissected ? linalg::dissectedOrder(matrix, 3) : std::vector<int>{}));
                EXPECT_LT(residual(matrix, solved(factor, matrix)), 1e-11) << side << " " << grids;
            }
        }
    }
}

TEST(FrontalCholesky, SaysWhatSparseCholeskySays) {
    const auto matrix = gridOfBlocks(30, 2);
    linalg::FrontalCholesky factor;
    ASSERT_TRUE(factor.analyse(matrix));
    linalg::SparseCholesky other;
    ASSERT_TRUE(other.factorise(matrix));
    const auto x = other.solve(someRight(matrix.size));
    ASSERT_TRUE(x);
    EXPECT_LT((solved(factor, matrix) - *x).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(FrontalCholesky, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto matrix = gridOfBlocks(60, 3), another = gridOfBlocks(60, 4);
    const auto order = linalg::dissectedOrder(matrix, 3);
    Eigen::VectorXd first;
    for (const int threads : {1, 2, 3, 16}) {
        linalg::FrontalCholesky factor(threads);
        ASSERT_TRUE(factor.analyse(matrix, order));
        EXPECT_TRUE(factor.refactorise(another));  // leaves no trace
        const Eigen::VectorXd x = solved(factor, matrix);
        if (threads == 1) {
            first = x;
        }
        EXPECT_TRUE(x == first) << threads;
    }
}

TEST(FrontalCholesky, RefusesWhatIsNotPositiveDefiniteAndGoesOn) {
    const auto matrix = gridOfBlocks(40, 5);
    for (const int threads : {1, 2}) {
        linalg::FrontalCholesky factor(threads);
        ASSERT_TRUE(factor.analyse(matrix));
        for (const int bad : {0, matrix.size / 2, matrix.size - 1}) {
            auto indefinite = matrix;
            indefinite.value[indefinite.columnStart[bad]] = -1;
            const auto done = factor.refactorise(indefinite);
            ASSERT_FALSE(done);
            EXPECT_EQ(done.error().code, ErrorCode::FactorisationFailed);
        }
        EXPECT_LT(residual(matrix, solved(factor, matrix)), 1e-11);
    }
}

#ifdef __linux__
/// What the process has of memory that counts for RLIMIT_DATA.
rlim_t dataBytes() {
    std::ifstream pages("/proc/self/statm");
    rlim_t size = 0;
    for (int field = 0; field < 6; ++field) {
        pages >> size;
    }
    return size * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

TEST(FrontalCholeskyDeathTest, EndsWhereMemoryIsShort) {
    const auto matrix = gridOfBlocks(30, 6, 12);
    const auto solveWith = [&matrix](rlim_t mebibytes) {
        linalg::FrontalCholesky factor(40);
        const bool isLaidOut = bool(factor.analyse(matrix));
        const rlim_t most = dataBytes() + (mebibytes << 20);
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_DATA, &limit);
        ::alarm(60);
        const auto done = factor.refactorise(matrix);
        const bool isRight = done ? residual(matrix, solved(factor, matrix)) < 1e-11
                                  : done.error().code == ErrorCode::OutOfMemory;
        std::_Exit(isLaidOut && isRight ? 0 : 1);
    };
    for (const rlim_t mebibytes : {20U, 130U, 300U, 500U}) {
        EXPECT_EXIT(solveWith(mebibytes), testing::ExitedWithCode(0), "") << mebibytes;
    }
}
#endif

}  // namespace
}  // namespace toile
