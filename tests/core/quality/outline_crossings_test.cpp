// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/quality/measures.h"

namespace toile {
namespace {

std::vector<int> loop(Eigen::Index n) {
    std::vector<int> indices(static_cast<std::size_t>(n));
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

/// Every pair, solved as two lines.
int bruteForce(const Points2& Q) {
    const int n = static_cast<int>(Q.rows());
    int count = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = i + 2; j < n; ++j) {
            if ((j + 1) % n == i) {
                continue;
            }
            Eigen::Matrix2d M;
            M.col(0) = (Q.row((i + 1) % n) - Q.row(i)).transpose();
            M.col(1) = (Q.row(j) - Q.row((j + 1) % n)).transpose();
            const Eigen::Vector2d s =
                M.inverse() * Eigen::Vector2d((Q.row(j) - Q.row(i)).transpose());
            count += s.minCoeff() > 0 && s.maxCoeff() < 1 ? 1 : 0;
        }
    }
    return count;
}

TEST(OutlineCrossings, ASquareHasNoneAndABowTieOne) {
    Points2 Q(4, 2);
    Q << 0, 0, 1, 0, 1, 1, 0, 1;
    EXPECT_EQ(outlineCrossings(Q, loop(4)), 0);
    Q << 0, 0, 1, 1, 1, 0, 0, 1;
    EXPECT_EQ(outlineCrossings(Q, loop(4)), 1);
}

TEST(OutlineCrossings, AgreesWithBruteForceOnRandomPolygons) {
    std::mt19937 random(5);
    for (int n = 4; n < 60; n += 5) {
        Points2 Q(n, 2);
        for (int i = 0; i < n; ++i) {
            Q.row(i) << random() / 4294967296.0, 3 * (random() / 4294967296.0);
        }
        EXPECT_EQ(outlineCrossings(Q, loop(n)), bruteForce(Q)) << n;
    }
}

TEST(OutlineCrossings, TheTwoSidesOfASlitDoNotCross) {
    // Down one side of the slit and up the other, with rounding between them.
    Points2 Q(11, 2);
    Q << 0, 0, 10, 0, 10, 10, 5, 10, 5 + 1e-14, 8, 5 - 1e-14, 6, 5, 4, 5 + 2e-14, 6, 5 - 2e-14, 8,
        5, 10, 0, 10;
    EXPECT_EQ(outlineCrossings(Q, loop(11)), 0);
}

TEST(OutlineCrossings, TouchingIsNoCrossing) {
    Points2 Q(6, 2);
    Q << 0, 0, 4, 0, 4, 3, 2, 0, 0, 3, -1, 1;  // a corner rests on the bottom edge
    EXPECT_EQ(outlineCrossings(Q, loop(6)), 0);
}

}  // namespace
}  // namespace toile
