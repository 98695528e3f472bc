// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notch_mark.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

/// On the lower side of a square: the cloth is above, the allowance below.
const NotchSpot kLower{{50, 0}, {0, -1}};

Points2 points(std::initializer_list<Eigen::RowVector2d> rows) {
    Points2 made(static_cast<Eigen::Index>(rows.size()), 2);
    Eigen::Index k = 0;
    for (const Eigen::RowVector2d& row : rows) {
        made.row(k++) = row;
    }
    return made;
}

void expectStrokes(const std::vector<Points2>& strokes, const std::vector<Points2>& expected) {
    ASSERT_EQ(strokes.size(), expected.size());
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        ASSERT_EQ(strokes[k].rows(), expected[k].rows());
        EXPECT_LT((strokes[k] - expected[k]).cwiseAbs().maxCoeff(), 1e-12) << strokes[k];
    }
}

TEST(NotchMark, StartsOnTheCuttingLineSquareToTheSeamLine) {
    const NotchSize size{4, 6, 8};
    expectStrokes(notchStrokes(kLower, 10, NotchForm::Slit, 1, size),
                  {points({{50, -10}, {50, -6}})});
    expectStrokes(notchStrokes(kLower, 10, NotchForm::V, 1, size),
                  {points({{47, -10}, {50, -6}, {53, -10}})});
    expectStrokes(notchStrokes(kLower, 10, NotchForm::T, 1, size),
                  {points({{50, -10}, {50, -6}}), points({{47, -6}, {53, -6}})});
    expectStrokes(notchStrokes(kLower, 10, NotchForm::Castle, 1, size),
                  {points({{47, -10}, {47, -6}, {53, -6}, {53, -10}})});
}

TEST(NotchMark, IsNoDeeperThanHalfTheAllowance) {
    expectStrokes(notchStrokes(kLower, 6, NotchForm::Slit, 1), {points({{50, -6}, {50, -3}})});
    expectStrokes(notchStrokes(kLower, 0, NotchForm::Slit, 1), {points({{50, 0}, {50, 5}})});
}

TEST(NotchMark, DoubleOnesLieSideBySideAboutTheSpot) {
    expectStrokes(notchStrokes(kLower, 10, NotchForm::Slit, 2, {4, 6, 8}),
                  {points({{46, -10}, {46, -6}}), points({{54, -10}, {54, -6}})});
}

TEST(NotchMark, SpotsLieOnTheLineAndPointAwayFromTheCloth) {
    const auto square = geometry::Line::closed(points({{0, 0}, {100, 0}, {100, 100}, {0, 100}}));
    const NotchSpot lower = notchSpot(square, 50), right = notchSpot(square, 130 + 400);
    EXPECT_LT((lower.point - kLower.point).norm(), 1e-12);
    EXPECT_LT((lower.outward - kLower.outward).norm(), 1e-12);
    EXPECT_LT((right.point - Eigen::Vector2d(100, 30)).norm(), 1e-12);
    EXPECT_LT((right.outward - Eigen::Vector2d(1, 0)).norm(), 1e-12);
    const auto hole = geometry::Line::closed(points({{0, 0}, {0, 100}, {100, 100}, {100, 0}}));
    EXPECT_LT((notchSpot(hole, 50).outward - Eigen::Vector2d(1, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace toile
