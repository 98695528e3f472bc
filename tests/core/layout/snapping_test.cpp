// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/snapping.h"

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace toile {
namespace {

Eigen::AlignedBox2d box(double x, double y, double width, double height) {
    return {Eigen::Vector2d(x, y), Eigen::Vector2d(x + width, y + height)};
}

Points2 corners(const Eigen::AlignedBox2d& box) {
    Points2 points(4, 2);
    points << box.min().x(), box.min().y(), box.max().x(), box.min().y(), box.max().x(),
        box.max().y(), box.min().x(), box.max().y();
    return points;
}

TEST(SnappedMove, GoesToTheGridWhereNothingElseIsNear) {
    SnapTargets targets;
    targets.gridStep = 10;
    const Eigen::AlignedBox2d piece = box(3, 4, 25, 25);
    const auto snapped = snappedMove(piece, corners(piece), {5.5, 40.9}, targets, 2);
    EXPECT_NEAR(piece.min().x() + snapped.way.x(), 10, 1e-12);  // 8.5: the left edge is 1.5 off
    EXPECT_NEAR(piece.max().y() + snapped.way.y(), 70, 1e-12);  // 69.9: the upper edge is nearer
    EXPECT_TRUE(snapped.lines.empty());
    const auto free = snappedMove(piece, corners(piece), {5.5, 40.9}, targets, 0.05);
    EXPECT_EQ(free.way, Eigen::Vector2d(5.5, 40.9));
}

TEST(SnappedMove, PrefersOtherPiecesToTheGrid) {
    SnapTargets targets;
    targets.gridStep = 10;
    targets.boxes = {box(101.3, 200, 50, 50)};
    const Eigen::AlignedBox2d piece = box(0, 0, 20, 20);
    const auto snapped = snappedMove(piece, Points2(0, 2), {100.2, 0}, targets, 3);
    EXPECT_NEAR(snapped.way.x(), 101.3, 1e-12);
    ASSERT_EQ(snapped.lines.size(), 1U);
    EXPECT_DOUBLE_EQ(snapped.lines[0].from.x(), 101.3);
    EXPECT_LE(snapped.lines[0].from.y(), 0);
    EXPECT_GE(snapped.lines[0].to.y(), 250);
    EXPECT_NEAR(snapped.way.y(), 0, 1e-12);  // of the grid
}

TEST(SnappedMove, JoinsVertices) {
    SnapTargets targets;
    targets.boxes = {box(100, 0, 50, 50)};
    targets.vertices = corners(targets.boxes[0]);
    const Eigen::AlignedBox2d piece = box(0, 0, 20, 20);
    const auto snapped = snappedMove(piece, corners(piece), {78.5, 1.2}, targets, 3);
    ASSERT_TRUE(snapped.vertex);
    EXPECT_EQ(*snapped.vertex, Eigen::Vector2d(100, 0));
    EXPECT_LT((snapped.way - Eigen::Vector2d(80, 0)).norm(), 1e-12);
}

TEST(SnappedMove, NeverGoesFartherThanItsReach) {
    SnapTargets targets;
    targets.gridStep = 10;
    targets.boxes = {box(30, 30, 7, 9), box(-40, 12, 33, 3)};
    targets.vertices = corners(targets.boxes[0]);
    const Eigen::AlignedBox2d piece = box(0, 0, 13, 17);
    for (int i = 0; i < 400; ++i) {
        const Eigen::Vector2d way(-50 + 0.37 * i, 60 - 0.29 * i);
        const auto snapped = snappedMove(piece, corners(piece), way, targets, 1.5);
        EXPECT_LT((snapped.way - way).cwiseAbs().maxCoeff(), 1.5);
    }
    EXPECT_EQ(snappedMove({}, Points2(0, 2), {1, 2}, targets, 5).way, Eigen::Vector2d(1, 2));
}

TEST(StraightDirections, ListsTheLongEdgesOnly) {
    // A rectangle whose upper edge is a row of many, and one corner is cut off.
    Points2 outline(9, 2);
    outline << 0, 0, 100, 0, 100, 48, 98, 50, 70, 50, 50, 50.1, 30, 50, 10, 50, 0, 50;
    const auto directions = straightDirections(outline);
    ASSERT_EQ(directions.size(), 4U);
    EXPECT_NEAR(directions[0], 0, 1e-12);
    EXPECT_NEAR(std::remainder(directions[1], kPi), 0, 0.01);
    EXPECT_NEAR(directions[2], kPi / 2, 1e-12);
    EXPECT_TRUE(straightDirections(Points2(0, 2)).empty());
    // A circle has no straight stretch.
    Points2 circle(90, 2);
    for (int i = 0; i < 90; ++i) {
        circle.row(i) << std::cos(2 * kPi * i / 90), std::sin(2 * kPi * i / 90);
    }
    EXPECT_TRUE(straightDirections(circle).empty());
}

TEST(OutlineCorners, AreWhereTheOutlineTurns) {
    Points2 outline(6, 2);
    outline << 0, 0, 50, 0, 100, 1, 100, 40, 50, 40, 0, 40;
    const Points2 found = snapPoints(outline);
    ASSERT_EQ(found.rows(), 4);
    EXPECT_EQ(found.row(1), outline.row(2));
    EXPECT_EQ(snapPoints(Points2(0, 2)).rows(), 0);
}

TEST(NearestEdgeDirection, IsThatOfTheNearestEdge) {
    const Points2 outline = corners(box(0, 0, 100, 40));
    EXPECT_NEAR(*nearestEdgeDirection(outline, {98, 20}), kPi / 2, 1e-12);
    EXPECT_NEAR(std::remainder(*nearestEdgeDirection(outline, {50, 38}), kPi), 0, 1e-12);
    EXPECT_FALSE(nearestEdgeDirection(Points2(0, 2), {0, 0}));
}

TEST(SnappedAngle, CatchesStepsAndOthersWithinReach) {
    const std::vector<double> others{0.3};
    EXPECT_DOUBLE_EQ(snappedAngle(kPi / 4 + 0.02, kPi / 4, others, 0.05), kPi / 4);
    EXPECT_NEAR(snappedAngle(0.32, kPi / 4, others, 0.05), 0.3, 1e-12);
    EXPECT_NEAR(snappedAngle(0.32 + kPi, kPi / 4, others, 0.05), 0.3 + kPi, 1e-12);
    EXPECT_DOUBLE_EQ(snappedAngle(0.4, kPi / 4, others, 0.05), 0.4);
}

}  // namespace
}  // namespace toile
