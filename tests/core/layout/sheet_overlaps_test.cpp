// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/layout/free_place.h"

namespace toile {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Points2 rectangle(double x, double y, double width, double height) {
    Points2 outline(4, 2);
    outline << x, y, x + width, y, x + width, y + height, x, y + height;
    return outline;
}

Points2 circle(double x, double y, double radius, int corners) {
    Points2 outline(corners, 2);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        outline.row(i) << x + radius * std::cos(angle), y + radius * std::sin(angle);
    }
    return outline;
}

TEST(SheetOverlaps, CrossingContainedAndEqualOutlinesOverlap) {
    const Points2 square = rectangle(0, 0, 100, 100);
    EXPECT_EQ(overlappingOutlines({square, rectangle(50, 50, 100, 100)}), (Pairs{{0, 1}}));
    EXPECT_EQ(overlappingOutlines({square, rectangle(40, 40, 10, 10)}), (Pairs{{0, 1}}));
    EXPECT_EQ(overlappingOutlines({square, square}), (Pairs{{0, 1}}));
    // A cross: no vertex of either lies in the other.
    EXPECT_EQ(overlappingOutlines({rectangle(0, 40, 100, 20), rectangle(40, 0, 20, 100)}),
              (Pairs{{0, 1}}));
}

TEST(SheetOverlaps, NeighboursAndTouchingEdgesDoNot) {
    const Points2 square = rectangle(0, 0, 100, 100);
    EXPECT_TRUE(overlappingOutlines({square, rectangle(100, 0, 100, 100)}).empty());
    EXPECT_TRUE(overlappingOutlines({square, rectangle(99.9995, 20, 100, 100)}).empty());
    EXPECT_TRUE(overlappingOutlines({square, rectangle(100, 100, 50, 50)}).empty());
    EXPECT_TRUE(overlappingOutlines({square, rectangle(300, 0, 100, 100)}).empty());
    // In the hollow of another: the boxes overlap, the cloth does not.
    Points2 hollow(8, 2);
    hollow << 0, 0, 100, 0, 100, 100, 80, 100, 80, 20, 20, 20, 20, 100, 0, 100;
    EXPECT_TRUE(overlappingOutlines({hollow, rectangle(30, 30, 40, 60)}).empty());
}

TEST(SheetOverlaps, WindingAndOrderDoNotMatter) {
    const Points2 one = circle(0, 0, 50, 400);
    const Points2 other = circle(70, 10, 40, 33).colwise().reverse();
    EXPECT_EQ(overlappingOutlines({one, other}), (Pairs{{0, 1}}));
    EXPECT_EQ(overlappingOutlines({other, one}), (Pairs{{0, 1}}));
    EXPECT_EQ(overlappingOutlines({circle(500, 0, 9, 12), one, other}), (Pairs{{1, 2}}));
}

TEST(SheetOverlaps, WhatIsNoOutlineLiesOnNothing) {
    Points2 broken = rectangle(0, 0, 100, 100);
    broken(2, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(
        overlappingOutlines({rectangle(0, 0, 100, 100), broken, Points2(0, 2), Points2(2, 2)})
            .empty());
}

}  // namespace
}  // namespace toile
