// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pole.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/pattern/allowance_shapes.h"
#include "tests/core/support/growth.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using test::rectangle;

constexpr PoleSearch kCloseSearch{.tolerance = 1e-4};
constexpr PoleSearch kMiddleSearch{.tolerance = 1e-3, .slack = 0.05};

Points2 regularPolygon(int count, double radius) {
    Points2 points(count, 2);
    for (int i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * i / count;
        points.row(i) << radius * std::cos(t), radius * std::sin(t);
    }
    return points;
}

Points2 outlineOf(std::initializer_list<Vector2d> corners) {
    Points2 points(corners.size(), 2);
    Eigen::Index i = 0;
    for (const Vector2d& corner : corners) {
        points.row(i++) = corner.transpose();
    }
    return points;
}

Points2 goingRound(const Points2& loop) {
    Points2 closed(loop.rows() + 1, 2);
    closed << loop, loop.row(0);
    return closed;
}

/// Whether a segment meets the inside of an upright box.
bool meetsBox(const Vector2d& a, const Vector2d& b, const Vector2d& middle, const Vector2d& size) {
    const Vector2d low = middle - 0.5 * size, high = middle + 0.5 * size;
    const auto share = geometry::shareInBox<Vector2d>(a, b - a, low, high);
    return share.first < share.last;
}

TEST(CirclePole, OfARectangleIsInItsMiddle) {
    const auto pole = circlePole({{rectangle(10, 20, 300, 80)}}, kCloseSearch);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->room, 40, 1e-9);
    EXPECT_NEAR((pole->place - Vector2d(160, 60)).norm(), 0, 1e-9);
}

TEST(CirclePole, OfATriangleIsItsIncircle) {
    // Sides 30, 40 and 50: radius 10.
    const auto pole = circlePole({{outlineOf({{0, 0}, {40, 0}, {0, 30}})}}, kCloseSearch);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->room, 10, 1e-3);
    EXPECT_NEAR((pole->place - Vector2d(10, 10)).norm(), 0, 0.1);
}

TEST(CirclePole, OfAnAngleTouchesItsInnerCorner) {
    const Points2 angle = outlineOf({{0, 0}, {200, 0}, {200, 60}, {60, 60}, {60, 200}, {0, 200}});
    const auto pole = circlePole({{angle}}, kCloseSearch);
    ASSERT_TRUE(pole);
    const double radius = 60 * (2 - std::numbers::sqrt2);
    EXPECT_NEAR(pole->room, radius, 0.01);
    EXPECT_NEAR((pole->place - Vector2d(radius, radius)).norm(), 0, 0.3);
}

TEST(CirclePole, OfARingIsHalfAsWide) {
    const auto pole =
        circlePole({{regularPolygon(400, 100), regularPolygon(400, 40)}}, kCloseSearch);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->room, 30, 0.01);
    EXPECT_NEAR(pole->place.norm(), 70, 0.05);
    // The hole as what is drawn there already: the same.
    const auto kept = circlePole(
        {{regularPolygon(400, 100)}, {goingRound(regularPolygon(400, 40))}}, kCloseSearch);
    ASSERT_TRUE(kept);
    EXPECT_NEAR(kept->room, 30, 0.01);
}

TEST(BoxPole, FillsARectangleInItsMiddle) {
    for (const Vector2d& size : {Vector2d(20, 5), Vector2d(1, 1), Vector2d(0.5, 30)}) {
        const auto pole = boxPole({{rectangle(-70, 30, 200, 90)}}, size, 0, kMiddleSearch);
        ASSERT_TRUE(pole);
        EXPECT_NEAR(pole->room, std::min(200 / size.x(), 90 / size.y()), 1e-9);
        EXPECT_NEAR((pole->place - Vector2d(30, 75)).norm(), 0, 1e-9);
    }
}

TEST(BoxPole, FillsATriangleUpToTheSlope) {
    const auto pole = boxPole({{outlineOf({{0, 0}, {120, 0}, {0, 90}})}}, {8, 3}, 0, kCloseSearch);
    ASSERT_TRUE(pole);
    const double room = 1 / (8.0 / 120 + 3.0 / 90);
    EXPECT_NEAR(pole->room, room, 1e-4 * room);
    EXPECT_NEAR((pole->place - room * Vector2d(4, 1.5)).norm(), 0, 0.1);
}

TEST(BoxPole, MayBeTurned) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    const Points2 outline = rectangle(100, 50, 400, 60) * turn.transpose();
    const auto pole = boxPole({{outline}}, {10, 1}, 0.7, kMiddleSearch);
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->room, 40, 1e-9);
    EXPECT_NEAR((pole->place - turn * Vector2d(300, 80)).norm(), 0, 1e-6);
}

TEST(BoxPole, KeepsOffObstacles) {
    const Points2 outline = rectangle(0, 0, 300, 100);
    Points2 line(2, 2);
    line << 100, 0, 100, 100;
    const auto beside = boxPole({{outline}, {line}}, {1, 1}, 0, kMiddleSearch);
    ASSERT_TRUE(beside);
    EXPECT_NEAR(beside->room, 95, 5.01);
    EXPECT_GT(beside->place.x(), 147);
    EXPECT_LT(beside->place.x(), 151);  // of the equals nearest to the middle
    // Inside what is taken there would be most room.
    const Points2 taken = goingRound(rectangle(5, 5, 200, 90));
    const auto off = boxPole({{outline}, {taken, taken}}, {1, 1}, 0, kMiddleSearch);
    ASSERT_TRUE(off);
    EXPECT_NEAR(off->room, 92.5, 2.51);
    EXPECT_GT(off->place.x(), 250);
    EXPECT_FALSE(
        boxPole({{outline}, {goingRound(rectangle(-5, -5, 400, 200))}}, {1, 1}, 0, kMiddleSearch));
}

TEST(BoxPole, MoreRoomThanEnoughIsNoBetter) {
    PoleSearch search = kMiddleSearch;
    search.enough = 10;
    // An arrow that points left: its centroid has 20, places to its right have more.
    const Points2 outline = outlineOf({{0, 0}, {300, -30}, {300, 30}});
    const auto pole = boxPole({{outline}}, {1, 1}, 0, search);
    ASSERT_TRUE(pole);
    EXPECT_NEAR((pole->place - Vector2d(200, 0)).norm(), 0, 1e-9);
    EXPECT_GT(boxPole({{outline}}, {1, 1}, 0)->place.x(), 250);
}

TEST(BoxPlace, IsThatOfThePoleWhereTheBoxFits) {
    const Points2 outline = outlineOf({{0, 0}, {300, -30}, {300, 30}});
    for (const double width : {5.0, 40.0, 55.0, 80.0, 500.0}) {
        const auto pole = boxPole({{outline}}, {width, width}, 0.2);
        const auto place = boxPlace({{outline}}, {width, width}, 0.2);
        ASSERT_TRUE(pole);
        ASSERT_EQ(place.has_value(), pole->room >= 1) << width;
        EXPECT_TRUE(!place || place->place == pole->place) << width;
    }
}

TEST(Pole, IsNoneWhereThereIsNoCloth) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(circlePole({}));
    EXPECT_FALSE(circlePole({{Points2(0, 2)}}));
    EXPECT_FALSE(circlePole({{rectangle(0, 0, 100, 0)}}));
    EXPECT_FALSE(circlePole({{rectangle(nan, 0, 100, 100)}}));
    EXPECT_FALSE(boxPole({{rectangle(0, 0, 100, 100)}}, {nan, 1}, 0));
    const auto tiny = circlePole({{rectangle(5, 5, 1e-9, 1e-9)}});
    EXPECT_TRUE(!tiny || tiny->place.allFinite());
}

TEST(Pole, OfRandomOutlinesHasTheRoomItSaysAndNoPlaceHasMore) {
    const Vector2d size(9, 2);
    for (unsigned seed = 0; seed < 16; ++seed) {
        const Points2 outline = test::randomAllowances(seed).seamLine;
        const FreeCloth cloth{{outline}, {goingRound(outline * 0.2)}};
        const auto pole = boxPole(cloth, size, 0);
        ASSERT_TRUE(pole) << seed;
        const auto isFree = [&](const Vector2d& middle, double room) {
            for (const Points2& line : {goingRound(outline), cloth.obstacles.front()}) {
                for (Eigen::Index i = 1; i < line.rows(); ++i) {
                    if (meetsBox(line.row(i - 1), line.row(i), middle, room * size)) {
                        return false;
                    }
                }
            }
            return test::outside(middle.transpose(), outline) < 0 &&
                   test::outside(middle.transpose(), outline * 0.2) > 0;
        };
        EXPECT_TRUE(isFree(pole->place, pole->room * (1 - 1e-9))) << seed;
        const Vector2d low = outline.colwise().minCoeff(), high = outline.colwise().maxCoeff();
        for (int i = 0; i < 100; ++i) {
            const Vector2d share(0.1 * (i % 10) + 0.05, 0.01 * i);
            EXPECT_FALSE(isFree(low + share.cwiseProduct(high - low), 1.0101 * pole->room)) << seed;
        }
    }
}

TEST(Pole, GoesWithThePieceAndWithItsImage) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const test::AllowanceCase shape = test::randomAllowances(seed);
        const auto pole = boxPole({{shape.seamLine}}, {9, 2}, 0, kMiddleSearch);
        const auto there =
            boxPole({{moved(shape, 0, {31, -17}).seamLine}}, {9, 2}, 0, kMiddleSearch);
        const auto image = boxPole({{mirrored(shape).seamLine}}, {9, 2}, 0, kMiddleSearch);
        ASSERT_TRUE(pole && there && image) << seed;
        EXPECT_NEAR(there->room / pole->room, 1, 0.06) << seed;
        EXPECT_NEAR(image->room / pole->room, 1, 0.06) << seed;
        // What is nearly as large as the largest may lie a little elsewhere.
        const Points2& outline = shape.seamLine;
        const double extent = (outline.colwise().maxCoeff() - outline.colwise().minCoeff()).norm();
        const Vector2d moves = there->place - Vector2d(31, -17) - pole->place;
        const Vector2d mirrors = image->place.cwiseProduct(Vector2d(-1, 1)) - pole->place;
        EXPECT_LT(moves.norm(), 0.01 * extent) << seed;
        EXPECT_LT(mirrors.norm(), 0.01 * extent) << seed;
    }
}

TEST(PoleClock, SmallClothIsSearchedCoarsely) {
    FreeCloth cloth;
    cloth.loops.emplace_back(4, 2);
    cloth.loops[0] << 0, 0, 30, 0, 30, 30, 0, 30;
    cloth.obstacles.emplace_back(5, 2);  // a label in the middle
    cloth.obstacles[0] << 8, 11, 22, 11, 22, 19, 8, 19, 8, 11;
    const PoleSearch exact{.tolerance = 0.02, .slack = 0.05};
    const PoleSearch coarse = coarserIfSmall(exact, cloth);
    const auto poleBy = [&cloth](const PoleSearch& search) -> std::optional<Pole> {
        return boxPole(cloth, {1, 0.1}, 1.5, search);
    };
    ASSERT_TRUE(poleBy(exact) && poleBy(coarse));
    EXPECT_GT(poleBy(coarse)->room, 0.85 * poleBy(exact)->room);
    const auto timeOf = [&poleBy](const PoleSearch& search) -> double {
        return test::quickest([&] {
            for (int k = 0; k < 20; ++k) {
                poleBy(search);
            }
        });
    };
    EXPECT_LT(4 * timeOf(coarse), timeOf(exact));
}

}  // namespace
}  // namespace toile
