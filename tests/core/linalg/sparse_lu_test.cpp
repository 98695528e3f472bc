// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/linalg/sparse_cholesky.h"

namespace toile {
namespace {

/// A path whose links weigh 1 one way and `back` the other, grounded at both ends.
std::vector<Eigen::Triplet<double>> path(int size, double back) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
        entries.emplace_back(i, i, 1 + back);
        if (i > 0) {
            entries.emplace_back(i, i - 1, -back);
            entries.emplace_back(i - 1, i, -1);
        }
    }
    return entries;
}

TEST(SparseLu, SolvesForSeveralColumns) {
    const int size = 40;
    const auto entries = path(size, 0.3);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    for (const auto& e : entries) {
        A(e.row(), e.col()) += e.value();
    }
    Eigen::MatrixXd X(size, 2);
    X.col(0).setLinSpaced(1, 2);
    X.col(1).setLinSpaced(-5, 7);
    const auto solved = linalg::solveUnsymmetric(entries, A * X);
    ASSERT_TRUE(solved);
    EXPECT_LE((*solved - X).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SparseLu, SumsEntries) {
    const auto solved =
        linalg::solveUnsymmetric({{0, 0, 1.5}, {0, 0, 2.5}}, Eigen::MatrixXd::Constant(1, 1, 8));
    ASSERT_TRUE(solved);
    EXPECT_DOUBLE_EQ((*solved)(0, 0), 2);
}

TEST(SparseLu, RefusesASingularMatrix) {
    const auto done = linalg::solveUnsymmetric({{0, 0, 1}, {0, 1, -1}, {1, 0, -1}, {1, 1, 1}},
                                               Eigen::MatrixXd::Ones(2, 1));
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::FactorisationFailed);
}

}  // namespace
}  // namespace toile
