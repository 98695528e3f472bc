// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

namespace toile::geometry {
namespace {

TEST(Polygon, TheHullHasTheCornersAloneAntiClockwise) {
    const Polygon points =
        (Polygon(8, 2) << 5, 5, 0, 0, 10, 0, 5, 0, 10, 10, 0, 10, 0, 10, 2, 7).finished();
    const Polygon hull = convexHull(points);
    ASSERT_EQ(hull.rows(), 4);
    EXPECT_EQ(signedAreaOf(hull), 100);
    EXPECT_EQ(boxAround(hull).diagonal(), Eigen::Vector2d(10, 10));
}

TEST(Polygon, TheHullOfFewPointsHasNoArea) {
    EXPECT_EQ(convexHull(Polygon(0, 2)).rows(), 0);
    EXPECT_EQ(signedAreaOf(convexHull((Polygon(1, 2) << 3, 4).finished())), 0);
    const Polygon line = (Polygon(3, 2) << 0, 0, 1, 1, 2, 2).finished();
    EXPECT_EQ(signedAreaOf(convexHull(line)), 0);
    EXPECT_EQ(boxAround(convexHull(line)).diagonal(), Eigen::Vector2d(2, 2));
}

}  // namespace
}  // namespace toile::geometry
