// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/layout/marker.h"

namespace toile {
namespace {

Points2 boxPoints(double x, double y, double width, double height) {
    Points2 points(4, 2);
    points << x, y, x + width, y, x + width, y + height, x, y + height;
    return points;
}

/// Pieces of many shapes and places; the same ones every time.
Pattern mixedPattern(int count, double scale) {
    Pattern pattern;
    for (int i = 0; i < count; ++i) {
        const double width = 100 + 37 * (i * 7 % 11), height = 60 + 53 * (i * 5 % 13);
        pattern.pieces.push_back(
            {{}, "p", "p", scale * boxPoints(-40.0 * i, 25.0 * i - 90, width, height)});
    }
    return pattern;
}

struct Placed {
    Eigen::Vector2d low, high;
};

Placed place(const Pattern& pattern, const Rows& rows, std::size_t i) {
    const Points2& outline = pattern.pieces[i].outline;
    return {outline.colwise().minCoeff().transpose() + rows.offset[i],
            outline.colwise().maxCoeff().transpose() + rows.offset[i]};
}

void expectGood(const Pattern& pattern, const Rows& rows, double gap) {
    ASSERT_EQ(rows.offset.size(), pattern.pieces.size());
    const double tolerance = 1e-12 * (rows.width + rows.height);
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const Placed a = place(pattern, rows, i);
        EXPECT_GE(a.low.minCoeff(), -tolerance);
        EXPECT_LE(a.high.x(), rows.width + tolerance);
        EXPECT_LE(a.high.y(), rows.height + tolerance);
        for (std::size_t j = 0; j < i; ++j) {
            const Placed b = place(pattern, rows, j);
            const Eigen::Vector2d apart =
                (a.low - b.high).cwiseMax(b.low - a.high);  // per axis, negative where they overlap
            EXPECT_GE(apart.maxCoeff(), gap - tolerance) << i << " and " << j;
        }
    }
}

TEST(LayOutInRows, KeepsPiecesApartAtAnyScale) {
    for (const double scale : {1e-7, 1e-3, 1.0, 1e3, 1e6}) {
        SCOPED_TRACE(scale);
        const Pattern pattern = mixedPattern(23, scale);
        const double largest = 60 + 53 * 12;
        expectGood(pattern, layOutInRows(pattern), std::min(20.0, 0.1 * largest * scale));
    }
}

TEST(LayOutInRows, IsBetweenASquareAndThreeToTwoForManyPieces) {
    for (const int count : {8, 23, 60, 200}) {
        const Rows rows = layOutInRows(mixedPattern(count, 1));
        EXPECT_GE(rows.width / rows.height, 0.95) << count;
        EXPECT_LE(rows.width / rows.height, 1.55) << count;
    }
}

TEST(LayOutInRows, StacksLongPiecesInsteadOfQueueingThem) {
    Pattern pattern;
    for (int i = 0; i < 6; ++i) {
        pattern.pieces.push_back({{}, "band", "band", boxPoints(0, 0, 900, 40)});
    }
    const Rows rows = layOutInRows(pattern);
    EXPECT_DOUBLE_EQ(rows.width, 900);
    EXPECT_DOUBLE_EQ(rows.height, 6 * 40 + 5 * 20);
    EXPECT_GT(rows.offset[0].y(), rows.offset[1].y());  // the first piece comes first
}

TEST(LayOutInRows, FitsOnePieceExactly) {
    Pattern pattern;
    pattern.pieces.push_back({{}, "one", "one", boxPoints(-300, 1000, 420, 650)});
    const Rows rows = layOutInRows(pattern);
    EXPECT_DOUBLE_EQ(rows.width, 420);
    EXPECT_DOUBLE_EQ(rows.height, 650);
    EXPECT_EQ(rows.offset[0], Eigen::Vector2d(300, -1000));
}

TEST(LayOutInRows, TakesNothingAndPiecesOfNoSize) {
    const Rows empty = layOutInRows(Pattern{});
    EXPECT_EQ(empty.width, 0);
    EXPECT_EQ(empty.height, 0);
    EXPECT_TRUE(empty.offset.empty());

    Pattern points;
    points.pieces.push_back({{}, "none", "none", Points2(0, 2)});
    points.pieces.push_back({{}, "dot", "dot", boxPoints(5, 5, 0, 0)});
    const Rows rows = layOutInRows(points);
    EXPECT_EQ(rows.offset.size(), 2u);
    EXPECT_TRUE(rows.offset[0].allFinite() && rows.offset[1].allFinite());
}

std::vector<Eigen::AlignedBox2d> boxesOf(const Pattern& pattern) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PatternPiece& piece : pattern.pieces) {
        boxes.push_back(outlineBox(piece.outline, {}));
    }
    return boxes;
}

Rows rowsOnCloth(const Pattern& pattern, double clothWidth) {
    return layOutInRows(boxesOf(pattern), std::vector<double>(pattern.pieces.size(), clothWidth));
}

TEST(LayOutInRows, KeepsToTheWidthOfTheCloth) {
    const Pattern pattern = mixedPattern(60, 1);
    const double free = layOutInRows(pattern).width;
    for (const double cloth : {1600.0, 1000.0, 500.0}) {
        SCOPED_TRACE(cloth);
        ASSERT_GT(free, cloth);
        const Rows rows = rowsOnCloth(pattern, cloth);
        expectGood(pattern, rows, 20);
        EXPECT_LE(rows.width, cloth);
    }
}

TEST(LayOutInRows, IsTheSameOnAClothThatIsWideEnough) {
    const Pattern pattern = mixedPattern(12, 1);
    const Rows free = layOutInRows(pattern);
    EXPECT_EQ(rowsOnCloth(pattern, free.width + 1).offset, free.offset);
}

TEST(LayOutInRows, GivesAPieceWiderThanTheClothARowOfItsOwn) {
    Pattern pattern;
    for (const double width : {300.0, 400.0, 1615.0, 300.0, 400.0}) {
        pattern.pieces.push_back({{}, "p", "p", boxPoints(0, 0, width, 100)});
    }
    const Rows rows = rowsOnCloth(pattern, 1400);
    expectGood(pattern, rows, 20);
    EXPECT_EQ(rows.width, 1615);
    const auto heightOf = [&](std::size_t i) { return rows.offset[i].y(); };
    EXPECT_EQ(heightOf(0), heightOf(1));
    EXPECT_GT(heightOf(1), heightOf(2));
    EXPECT_GT(heightOf(2), heightOf(3));
    EXPECT_EQ(heightOf(3), heightOf(4));
}

TEST(LayOutInRows, ANarrowClothIsTheLimitOfItsOwnRowAlone) {
    Pattern pattern = mixedPattern(40, 1);
    pattern.pieces.push_back({{}, "ribbon", "ribbon", boxPoints(0, 0, 40, 300)});
    std::vector<double> clothWidths(40, 1400);
    clothWidths.push_back(50);
    const std::vector<Eigen::AlignedBox2d> boxes = boxesOf(pattern);
    const Rows rows = layOutInRows(boxes, clothWidths);
    expectGood(pattern, rows, 20);
    EXPECT_GT(rows.width, 1000);
    EXPECT_LE(rows.width, 1400);
    const double ribbonTop = boxes[40].max().y() + rows.offset[40].y();
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_GT(boxes[i].min().y() + rows.offset[i].y(), ribbonTop) << i;
    }
}

TEST(LayOutInRows, TheClothOfWhatIsNotThereIsNoLimit) {
    Pattern pattern = mixedPattern(12, 1);
    const Rows without = rowsOnCloth(pattern, 1400);
    pattern.pieces.push_back({{}, "none", "none", Points2(0, 2)});
    std::vector<double> clothWidths(12, 1400);
    clothWidths.push_back(50);
    Rows with = layOutInRows(boxesOf(pattern), clothWidths);
    with.offset.pop_back();
    EXPECT_EQ(with.offset, without.offset);
}

TEST(LayOutInRows, GivesTheSameRowsTwice) {
    const Pattern pattern = mixedPattern(40, 1.7);
    EXPECT_EQ(layOutInRows(pattern).offset, layOutInRows(pattern).offset);
}

}  // namespace
}  // namespace toile
