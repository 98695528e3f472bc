// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/line.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/polygon.h"

namespace toile::geometry {
namespace {

constexpr double kSame = 1e-12;

Polygon rectangle() {
    return (Polygon(4, 2) << 0, 0, 30, 0, 30, 10, 0, 10).finished();
}

TEST(Line, OfARectangleIsMeasuredAlongItsEdges) {
    const Line line = Line::closed(rectangle());
    EXPECT_EQ(line.length(), 80);
    EXPECT_EQ(line.arc().values(), (std::vector<double>{0, 30, 40, 70, 80}));
    EXPECT_EQ(line.pointAt(35), Eigen::RowVector2d(30, 5));
    EXPECT_EQ(line.edgeAt(30), 1);
    EXPECT_EQ(line.nearestPlace({12, -4}), 12);
    EXPECT_NEAR(line.turnAt(2), std::numbers::pi / 2, kSame);
    EXPECT_EQ(line.apart(5, 75), 10);
}

TEST(Line, PlacesAndPointsCountOnOverTurns) {
    const Line line = Line::closed(rectangle());
    for (const int turns : {-2, -1, 0, 1, 3}) {
        EXPECT_NEAR(line.wrap(35 + 80 * turns), 35, kSame);
        EXPECT_EQ(line.placeOf(1 + 4 * turns), 30 + 80 * turns);
        EXPECT_EQ(line.point(1 + 4 * turns), line.point(1));
        EXPECT_EQ(line.firstAfter(35 + 80 * turns), 2 + 4 * turns);
        EXPECT_TRUE(line.pointAt(35 + 80 * turns).isApprox(line.pointAt(35)));
    }
}

TEST(Line, ThatIsOpenEndsAtItsEnds) {
    const Line line = Line::open(rectangle());
    EXPECT_EQ(line.length(), 70);
    EXPECT_EQ(line.pointAt(-5), line.point(0));
    EXPECT_EQ(line.pointAt(500), line.point(3));
    EXPECT_EQ(line.firstAfter(0), 1);
    EXPECT_EQ(line.firstAfter(70), 3);
    EXPECT_EQ(line.part(0, 70), line.points());
    EXPECT_EQ(Line::open((Polygon(1, 2) << 3, 4).finished()).pointAt(7), Eigen::RowVector2d(3, 4));
}

TEST(Line, AnyPartIsAsLongAsItsPlacesAreApart) {
    const Line line = Line::closed(rectangle());
    for (double from = -90; from < 90; from += 7) {
        for (double length = 1; length < 160; length += 11) {
            EXPECT_NEAR(line.lengthOf(from, from + length), length, 1e-9) << from << ' ' << length;
        }
    }
    EXPECT_EQ(line.part(30, 40), (Polygon(2, 2) << 30, 0, 30, 10).finished());  // no point twice
}

TEST(Line, APlaceKeepsItsShareOfAnEdgeInAnotherMeasure) {
    const Line line = Line::closed(rectangle());
    const Line stretched = Line::closed(rectangle(), {5, 65, 66, 126, 127});
    EXPECT_EQ(line.placeOn(stretched, 15), 35);
    for (double place = -100; place < 200; place += 3) {
        EXPECT_NEAR(stretched.placeOn(line, line.placeOn(stretched, place)), place, 1e-9);
    }
}

TEST(Line, InSpaceTurnsByTheAngleOfItsEdges) {
    const SpaceLine line =
        SpaceLine::open((SpaceLine::Points(3, 3) << 0, 0, 0, 1, 0, 0, 1, 0, 2).finished());
    EXPECT_EQ(line.length(), 3);
    EXPECT_NEAR(line.turnAt(1), std::numbers::pi / 2, kSame);
    EXPECT_EQ(line.nearestPlace({5, 0, 1}), 2);
}

TEST(Line, CommonPartsOfStretchesAreFoundAcrossTheFirstPoint) {
    const auto parts = commonParts({70, 95}, {-5, 20}, 80);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].low, 75);
    EXPECT_EQ(parts[0].high, 95);
    EXPECT_EQ(parts[0].shift, 80);
    const auto both = commonParts({0, 80}, {60, 100}, 80);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].length() + both[1].length(), 40);
    EXPECT_TRUE(commonParts({0, 10}, {10, 20}, 80).empty());
}

}  // namespace
}  // namespace toile::geometry
