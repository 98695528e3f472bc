// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/core/linalg/symmetric_product.h"

namespace toile {
namespace {

constexpr int kWide = 150;

/// A Laplacian over a square sheet of kWide by kWide unknowns with diagonals, definite.
linalg::SymmetricMatrix sheetMatrix() {
    linalg::SymmetricBuilder builder(kWide * kWide);
    for (int y = 0; y < kWide; ++y) {
        for (int x = 0; x < kWide; ++x) {
            const int i = y * kWide + x;
            builder.add(i, i, 6.01);
            if (x + 1 < kWide) {
                builder.add(i + 1, i, -1);
            }
            if (y + 1 < kWide) {
                builder.add(i + kWide, i, -1);
            }
            if (x + 1 < kWide && y + 1 < kWide) {
                builder.add(i + kWide + 1, i, -1);
            }
        }
    }
    return builder.build();
}

/// The sheet flat, or rolled up: `turns` layers over each other.
linalg::Places sheetPlaces(int turns = 0) {
    linalg::Places places(kWide * kWide, 3);
    for (int i = 0; i < kWide * kWide; ++i) {
        const double x = i % kWide;
        const double angle = 2 * M_PI * turns * x / kWide;
        places.row(i) << x, i / kWide, 0;
        if (turns > 0) {
            places.row(i) << (1 + 1e-3 * x) * std::cos(angle), 1e-3 * (i / kWide),
                (1 + 1e-3 * x) * std::sin(angle);
        }
    }
    return places;
}

TEST(EliminationOrder, TakesEachUnknownOnce) {
    std::vector<int> order = linalg::eliminationOrder(sheetMatrix(), sheetPlaces());
    std::ranges::sort(order);
    std::vector<int> all(kWide * kWide);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
}

TEST(EliminationOrder, LeavesWhatPartsTheSheetToTheEnd) {
    const std::vector<int> order = linalg::eliminationOrder(sheetMatrix(), sheetPlaces());
    ASSERT_EQ(order.size(), kWide * kWide);
    // A row or a column of the sheet, and what its diagonals reach.
    int low = kWide;
    int high = 0;
    for (auto it = order.end() - kWide; it != order.end(); ++it) {
        low = std::min(low, *it % kWide);
        high = std::max(high, *it % kWide);
    }
    EXPECT_LE(high - low, 1);
    EXPECT_NEAR(low, kWide / 2, 1);
}

TEST(EliminationOrder, GivesTheSameSolutionWithLessOfAFactor) {
    const linalg::SymmetricMatrix matrix = sheetMatrix();
    linalg::SparseCholesky byDegree;
    linalg::SparseCholesky dissected;
    ASSERT_TRUE(byDegree.factorise(matrix));
    ASSERT_TRUE(dissected.analyse(matrix, linalg::eliminationOrder(matrix, sheetPlaces())));
    ASSERT_TRUE(dissected.refactorise(matrix));
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(matrix.size, 2);
    const auto x = dissected.solve(b);
    ASSERT_TRUE(x);
    EXPECT_LE((test::times(matrix, *x) - b).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((*x - *byDegree.solve(b)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE(static_cast<double>(dissected.bytes()), 1.3 * static_cast<double>(byDegree.bytes()));
}

TEST(EliminationOrder, LeavesASheetThatIsRolledUpToMinimumDegree) {
    EXPECT_FALSE(linalg::eliminationOrder(sheetMatrix(), sheetPlaces(1)).empty());
    EXPECT_TRUE(linalg::eliminationOrder(sheetMatrix(), sheetPlaces(12)).empty());
}

/// The sheet with three unknowns to a place, each of which acts on the places next to it.
linalg::SymmetricMatrix thickSheetMatrix() {
    const linalg::SymmetricMatrix thin = sheetMatrix();
    linalg::SymmetricBuilder builder(3 * thin.size);
    for (int j = 0; j < thin.size; ++j) {
        for (int k = thin.columnStart[j]; k < thin.columnStart[j + 1]; ++k) {
            for (int axis = 0; axis < 9; ++axis) {
                const int row = 3 * thin.row[k] + axis / 3, column = 3 * j + axis % 3;
                if (row >= column) {
                    builder.add(row, column, row == column ? 20 : axis / 3 == axis % 3 ? -1 : 0.1);
                }
            }
        }
    }
    return builder.build();
}

TEST(EliminationOrder, DissectsWhatHasNoPlacesAndKeepsTogetherWhatIsOne) {
    const linalg::SymmetricMatrix matrix = thickSheetMatrix();
    const std::vector<int> order = linalg::dissectedOrder(matrix, 3);
    if (order.empty()) {
        GTEST_SKIP() << "CHOLMOD without METIS";
    }
    std::vector<int> sorted = order;
    std::ranges::sort(sorted);
    std::vector<int> all(static_cast<std::size_t>(matrix.size));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
    EXPECT_EQ(order, linalg::dissectedOrder(matrix, 3));
    for (std::size_t i = 0; i < order.size(); i += 3) {
        EXPECT_EQ(order[i] % 3, 0);
        EXPECT_EQ(order[i + 2], order[i] + 2);
    }
    linalg::SparseCholesky byDegree;
    linalg::SparseCholesky dissected;
    ASSERT_TRUE(byDegree.factorise(matrix));
    ASSERT_TRUE(dissected.analyse(matrix, order));
    ASSERT_TRUE(dissected.refactorise(matrix));
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(matrix.size, 1);
    EXPECT_LE((*dissected.solve(b) - *byDegree.solve(b)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE(static_cast<double>(dissected.bytes()), 1.05 * static_cast<double>(byDegree.bytes()));
}

}  // namespace
}  // namespace toile
