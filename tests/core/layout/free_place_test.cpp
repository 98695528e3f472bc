// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/free_place.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr double kGap = 10;

Points2 rectanglePoints(double x, double y, double width, double height) {
    Points2 points(4, 2);
    points << x, y, x + width, y, x + width, y + height, x, y + height;
    return points;
}

Points2 circlePoints(double x, double y, double radius, int count = 200) {
    Points2 points(count, 2);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        points.row(i) << x + radius * std::cos(angle), y + radius * std::sin(angle);
    }
    return points;
}

Points2 moved(Points2 points, const Eigen::Vector2d& by) {
    points.rowwise() += by.transpose();
    return points;
}

void expectFree(const Points2& outline, const std::vector<Points2>& others) {
    std::vector<Points2> all = others;
    all.push_back(outline);
    for (const auto& [a, b] : overlappingOutlines(all)) {
        EXPECT_NE(b, static_cast<int>(others.size())) << "lies on " << a;
    }
}

TEST(FreePlace, WhatIsFreeStays) {
    EXPECT_EQ(
        moveToFreePlace(circlePoints(0, 0, 50), {circlePoints(200, 0, 50), Points2(0, 2)}, kGap)
            .norm(),
        0);
    EXPECT_EQ(moveToFreePlace(Points2(0, 2), {circlePoints(0, 0, 50)}, kGap).norm(), 0);
}

TEST(FreePlace, OneThingGivesWayByTheShortestWay) {
    const Points2 wide = rectanglePoints(0, 0, 1000, 300);
    for (const double y : {10.0, 120.0, 200.0}) {
        const Points2 patch = circlePoints(500, y, 40);
        const Eigen::Vector2d move = moveToFreePlace(patch, {wide}, kGap);
        expectFree(moved(patch, move), {wide});
        const double shortest = std::min(y, 300 - y) + 40 + kGap;
        EXPECT_GE(move.norm(), shortest - 0.01);
        EXPECT_LE(move.norm(), 1.05 * shortest + 0.3 * kGap);
    }
}

TEST(FreePlace, ARoomThatIsLargeEnoughIsFoundBetweenOthers) {
    // Free on one side only, and there not too far.
    const std::vector<Points2> others{
        rectanglePoints(0, 0, 300, 300), rectanglePoints(-320, 0, 310, 300),
        rectanglePoints(310, 0, 300, 300), rectanglePoints(-320, 310, 930, 300)};
    const Points2 patch = circlePoints(150, 200, 30);
    const Eigen::Vector2d move = moveToFreePlace(patch, others, kGap);
    expectFree(moved(patch, move), others);
    EXPECT_LT(move.norm(), 1.2 * (230 + kGap));
    EXPECT_LT(move.y(), 0);
}

TEST(FreePlace, ABayIsAFreePlace) {
    Points2 bay(8, 2);  // open upwards
    bay << 0, 0, 300, 0, 300, 300, 200, 300, 200, 100, 100, 100, 100, 300, 0, 300;
    const Points2 patch = circlePoints(150, 80, 20);
    const Eigen::Vector2d move = moveToFreePlace(patch, {bay}, kGap);
    expectFree(moved(patch, move), {bay});
    EXPECT_LT(move.norm(), 60);
}

TEST(FreePlace, ItIsTheSameEverywhereOnTheSheetAndInEveryUnit) {
    const Points2 patch = circlePoints(90, 40, 30), other = rectanglePoints(0, 0, 200, 150);
    const Eigen::Vector2d move = moveToFreePlace(patch, {other}, kGap);
    const Eigen::Vector2d far(4000, -700);
    EXPECT_LT((moveToFreePlace(moved(patch, far), {moved(other, far)}, kGap) - move).norm(), 1e-6);
    EXPECT_LT((moveToFreePlace(1000 * patch, {1000 * other}, 1000 * kGap) - 1000 * move).norm(),
              1e-3);
}

}  // namespace
}  // namespace toile
