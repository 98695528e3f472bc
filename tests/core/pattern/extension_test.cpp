// SPDX-License-Identifier: GPL-3.0-or-later
// Free edges that are drawn out parallel.
#include "core/pattern/extension.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/pattern/piece_allowance.h"
#include "tests/core/pattern/allowance_shapes.h"

namespace toile {
namespace {

/// A piece of free edges from corner to corner, numbered from 1.
PatternPiece polygonPiece(const std::vector<Eigen::RowVector2d>& corners) {
    PatternPiece piece;
    piece.outline.resize(static_cast<Eigen::Index>(corners.size()), 2);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        piece.outline.row(static_cast<Eigen::Index>(k)) = corners[k];
    }
    const auto outline = geometry::Line::closed(piece.outline);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        PatternSegment& segment = piece.segments.emplace_back();
        segment.from = outline.arc()[k];
        segment.to = outline.arc()[k + 1];
        segment.isCorner = true;
        segment.seam = static_cast<int>(k) + 1;
    }
    return piece;
}

PatternPiece rectangle() {
    return polygonPiece({{0, 0}, {100, 0}, {100, 60}, {0, 60}});
}

PatternPiece disk(double radius, int count) {
    std::vector<Eigen::RowVector2d> corners;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    PatternPiece piece = polygonPiece(corners);
    piece.segments.resize(1);
    piece.segments.front().to = geometry::Line::closed(piece.outline).length();
    return piece;
}

TEST(Extension, OfARectangleIsALongerOne) {
    PatternPiece piece = rectangle();
    piece.segments[1].extension = 20;
    addCuttingLine(piece);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine), 120.0 * 60, 1e-3);
    ASSERT_EQ(piece.extensions.size(), 1U);
    ASSERT_EQ(piece.extensions[0].rows(), 2);
    EXPECT_NEAR(piece.extensions[0](0, 0), 120, 1e-5);
    EXPECT_NEAR(piece.extensions[0](0, 1), 0, 1e-5);
    EXPECT_NEAR(piece.extensions[0](1, 1), 60, 1e-5);
}

/// What is drawn out has the allowance of its edge, and the way there that of the edges beside it.
TEST(Extension, HasTheAllowancesOfTheEdgesThatRunOn) {
    PatternPiece piece = rectangle();
    piece.segments[1].extension = 20;
    const double widths[] = {5, 7, 9, 11};
    for (std::size_t k = 0; k < 4; ++k) {
        piece.segments[k].allowance = widths[k];
        piece.segments[k].corner = CornerRule::Mitre;
    }
    addCuttingLine(piece);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine), (11 + 100 + 20 + 7) * (5.0 + 60 + 9), 1e-2);
}

TEST(Extension, RunsOnAsTheEdgesBesideItDo) {
    // The upper edge rises at 45 degrees: prolonged by 20 it is 20 higher there.
    PatternPiece piece = polygonPiece({{0, 0}, {100, 0}, {100, 100}, {0, 0.5}});
    piece.segments[1].extension = 20;
    addCuttingLine(piece);
    ASSERT_EQ(piece.extensions.size(), 1U);
    const double slope = 99.5 / 100;
    EXPECT_NEAR(piece.extensions[0](1, 1), 100 + 20 * slope, 1e-4);
    piece.segments[1].corner = piece.segments[2].corner = CornerRule::Stepped;
    addCuttingLine(piece);
    ASSERT_EQ(piece.extensions.size(), 1U);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine) - test::areaOf(piece.outline), 20.0 * 100, 1e-2);
}

TEST(Extension, OfADiskIsALargerOne) {
    PatternPiece piece = disk(100, 720);
    piece.segments.front().extension = 30;
    addCuttingLine(piece);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine), std::numbers::pi * 130 * 130, 2);
    EXPECT_EQ(piece.extensions.size(), 1U);
    piece.segments.front().allowance = 10;
    addCuttingLine(piece);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine), std::numbers::pi * 140 * 140, 3);
}

TEST(Extension, OfEdgesThatMeetIsOneLine) {
    PatternPiece piece = rectangle();
    piece.segments[0].extension = 10;
    piece.segments[1].extension = 20;
    addCuttingLine(piece);
    EXPECT_NEAR(test::areaOf(piece.cuttingLine), 120.0 * 70, 1e-2);
    EXPECT_EQ(piece.extensions.size(), 2U);
}

TEST(Extension, IsOfFreeEdgesOnly) {
    PatternPiece piece = rectangle();
    piece.segments[1].extension = 20;
    piece.segments[1].kind = SeamKind::Seam;
    addCuttingLine(piece);
    EXPECT_TRUE(piece.extensions.empty());
    EXPECT_EQ(piece.cuttingLine, piece.outline);
}

/// Whatever the outline: simple, and never inside it.
TEST(Extension, OfRandomOutlinesIsRoundThem) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        test::AllowanceCase shape = test::randomAllowances(seed);
        PatternPiece piece;
        piece.outline = shape.seamLine;
        const auto outline = geometry::Line::closed(piece.outline);
        for (std::size_t k = 0; k < shape.stretches.size(); ++k) {
            const bool isLast = k + 1 == shape.stretches.size();
            const int first = shape.stretches[k].first;
            PatternSegment& segment = piece.segments.emplace_back();
            segment.from = outline.arc()[static_cast<std::size_t>(first)];
            const int next = shape.stretches[isLast ? 0 : k + 1].first;
            segment.to =
                outline.arc()[static_cast<std::size_t>(next)] + (isLast ? outline.length() : 0);
            segment.seam = static_cast<int>(k) + 1;
            segment.extension = k % 2 == 0 ? shape.stretches[k].width : 0;
            segment.corner = CornerRule::Mitre;
        }
        addCuttingLine(piece);
        for (AllowanceStretch& stretch : shape.stretches) {
            stretch.corner = CornerRule::Mitre;
        }
        for (std::size_t k = 1; k < shape.stretches.size(); k += 2) {
            shape.stretches[k].width = 0;
        }
        EXPECT_EQ(test::troubleWith(shape, piece.cuttingLine), "") << seed;
    }
}

}  // namespace
}  // namespace toile
