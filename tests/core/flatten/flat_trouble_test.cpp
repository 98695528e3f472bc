// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/flat_trouble.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/flat_of.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// The shapes are what they promise, and their exact-length outlines are in trouble.
PieceQuality flattened(const Piece& piece, Method method) {
    return measure(piece, test::flatOf(piece, method));
}

TEST(FlatTrouble, ASaddlesSlitCrossesItself) {
    for (const int side : {8, 16, 24}) {
        for (const double bend : {0.3, 1.0, 2.0}) {
            const auto piece = test::asPiece(test::saddleWithSlit(side, 200, bend));
            ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
            EXPECT_EQ(piece->boundary.size(), 4 * side + side);
            for (const Method method : {Method::Wang2005, Method::Curvature}) {
                const PieceQuality quality = flattened(*piece, method);
                EXPECT_GT(quality.outlineCrossings, 0);
                EXPECT_LE(quality.maxBoundaryLengthError, 1e-12);
            }
        }
    }
}

TEST(FlatTrouble, AFlounceOfMoreThanATurnLiesOnItself) {
    for (const double turn : {355.0, 400.0, 420.0, 720.0}) {
        const auto piece = test::asPiece(test::flounce(turn, 80, 200, 120, 5));
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        // A ring sector: its area is the turn's share of the rings'.
        const double area = turn / 360 * std::numbers::pi * (200 * 200 - 80 * 80);
        EXPECT_NEAR(triangleAreas3d(piece->mesh).sum(), area, 0.005 * area);
        const PieceQuality quality = flattened(*piece, Method::Curvature);
        EXPECT_NEAR(quality.symmetricDirichlet.value_or(0), 1, 1e-9);  // developable
        EXPECT_EQ(quality.outlineCrossings > 0, turn > 360);
    }
}

TEST(FlatTrouble, SliversKeepTheirOutlinesLengths) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const auto piece = test::asPiece(test::sliverGrid(12, 13, 10, seed));
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        EXPECT_GT(cornerAngles3d(piece->mesh).maxCoeff(), 0.99 * std::numbers::pi / 2);
        for (const Method method : {Method::Wang2005, Method::Curvature}) {
            EXPECT_LE(flattened(*piece, method).maxBoundaryLengthError, 1e-9);
        }
    }
}

}  // namespace
}  // namespace toile
