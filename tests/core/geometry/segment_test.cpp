// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/segment.h"

#include <numbers>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace toile {
namespace {

const Eigen::Vector2d kFrom(1, 2), kTo(5, 5);  // 5 long

TEST(Segment, HasAnAngleToAnother) {
    const Eigen::Vector2d x(2, 0), y(0, 3);
    EXPECT_DOUBLE_EQ(geometry::turnBetween(x, y), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(geometry::turnBetween(y, x), -std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(geometry::angleBetween(y, x), std::numbers::pi / 2);
    EXPECT_EQ(geometry::angleBetween(x, 2 * x), 0);
    EXPECT_DOUBLE_EQ(geometry::angleBetween(x, -x), std::numbers::pi);
    // A hundred million times as long as apart: the cosine is 1.
    const Eigen::RowVector3d along(1, 2, 2),
        beside = along + 3e-8 * Eigen::RowVector3d(2, 1, -2) / 3;
    EXPECT_NEAR(geometry::angleBetween(along, beside), 1e-8, 1e-15);
}

TEST(Segment, IsNearestWhereTheWayMeetsItAtRightAngles) {
    const Eigen::Vector2d across(-0.6, 0.8);
    for (const double share : {0.0, 0.25, 1.0}) {
        const Eigen::Vector2d point = kFrom + share * (kTo - kFrom) + 3 * across;
        EXPECT_NEAR(geometry::nearestShare(point, kFrom, kTo), share, 1e-12);
        EXPECT_NEAR(geometry::distanceToSegment(point, kFrom, kTo), 3, 1e-12);
    }
}

TEST(Segment, EndsAtItsEnds) {
    const Eigen::Vector2d way = kTo - kFrom;
    EXPECT_EQ(geometry::nearestShare<Eigen::Vector2d>(kFrom - way, kFrom, kTo), 0);
    EXPECT_EQ(geometry::nearestShare<Eigen::Vector2d>(kTo + way, kFrom, kTo), 1);
    EXPECT_NEAR(geometry::distanceToSegment<Eigen::Vector2d>(kTo + way, kFrom, kTo), 5, 1e-12);
}

TEST(Segment, WithoutLengthIsAPoint) {
    const Eigen::RowVector3d place(1, 2, 3), point(1, 2, 7);
    EXPECT_EQ(geometry::nearestShare(point, place, place), 0);
    EXPECT_EQ(geometry::distanceToSegment(point, place, place), 4);
}

}  // namespace
}  // namespace toile
