// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/sparse_lu.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A path whose links weigh 1 one way and `back` the other, grounded at both ends.
std::vector<MatrixEntry> path(int size, double back) {
    std::vector<MatrixEntry> entries;
    for (int i = 0; i < size; ++i) {
        entries.push_back({i, i, 1 + back});
        if (i > 0) {
            entries.push_back({i, i - 1, -back});
            entries.push_back({i - 1, i, -1});
        }
    }
    return entries;
}

TEST(SparseLu, SolvesForSeveralColumns) {
    const int size = 40;
    const auto entries = path(size, 0.3);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    for (const MatrixEntry& e : entries) {
        A(e.row, e.column) += e.value;
    }
    Eigen::MatrixXd X(size, 2);
    X.col(0).setLinSpaced(1, 2);
    X.col(1).setLinSpaced(-5, 7);
    SparseLu lu;
    ASSERT_TRUE(lu.factorise(size, entries));
    const auto solved = lu.solve(A * X);
    ASSERT_TRUE(solved);
    EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SparseLu, SumsEntriesAndForgetsTheFormerMatrix) {
    SparseLu lu;
    ASSERT_TRUE(lu.factorise(40, path(40, 0.3)));
    ASSERT_TRUE(lu.factorise(1, {{0, 0, 1.5}, {0, 0, 2.5}}));
    const auto solved = lu.solve(Eigen::MatrixXd::Constant(1, 1, 8));
    ASSERT_TRUE(solved);
    EXPECT_DOUBLE_EQ((*solved)(0, 0), 2);
}

TEST(SparseLu, RefusesASingularMatrix) {
    SparseLu lu;
    const auto done = lu.factorise(2, {{0, 0, 1}, {0, 1, -1}, {1, 0, -1}, {1, 1, 1}});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::FactorisationFailed);
}

}  // namespace
}  // namespace toile
