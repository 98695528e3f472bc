// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/nest/item_rings.h"
#include "tests/core/nest/nest_shapes.h"

namespace {

using namespace toile;
using geometry::Polygon;

/// A wavy round of many points.
Polygon manyPoints(nest::Random& random, int count) {
    Polygon ring(count, 2);
    const double waves = static_cast<double>(2 + random.below(6)), depth = random.between(5, 40);
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * kPi * k / count;
        const double radius = 150 + depth * std::sin(waves * angle) + random.between(0, 0.05);
        ring.row(k) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return ring;
}

double distanceTo(const Polygon& ring, const Eigen::Vector2d& point) {
    double least = HUGE_VAL;
    for (Eigen::Index k = 0; k < ring.rows(); ++k) {
        const Eigen::Vector2d a = ring.row(k), b = ring.row((k + 1) % ring.rows());
        least = std::min(least, geometry::distanceToSegment(point, a, b));
    }
    return least;
}

TEST(Simplify, FewerPointsLieAroundAndNear) {
    constexpr double kTolerance = 0.4;
    for (int k = 0; k < 3; ++k) {
        nest::Random random(static_cast<std::uint64_t>(k), 0, 0);
        const Polygon all = manyPoints(random, 1000);
        const Polygon fewer = nest::simplified({all}, kTolerance, 10).front();
        EXPECT_LT(fewer.rows(), 200);
        for (Eigen::Index p = 0; p < all.rows(); p += 7) {
            const Eigen::Vector2d point = all.row(p);
            EXPECT_TRUE(geometry::isInside(fewer, point) || distanceTo(fewer, point) < 1e-9);
        }
        for (Eigen::Index p = 0; p < fewer.rows(); ++p) {
            EXPECT_LE(distanceTo(all, fewer.row(p)), kTolerance);
        }
    }
}

TEST(Simplify, StopsAtEnoughAndKeepsWhatItMust) {
    nest::Random random(3);
    EXPECT_EQ(nest::simplified({manyPoints(random, 500)}, 50, 60).front().rows(), 60);
    const Polygon square = test::nestRectangle(10, 10);
    EXPECT_EQ(nest::simplified({square}, 1, 1).front(), square);
}

TEST(Simplify, ANarrowNotchStaysOpen) {
    // Its sides go apart from each other, so that either could be cut off into the other.
    const Polygon notched = test::nestPolygon({{0, 0},
                                               {100, 0},
                                               {100, 49.9},
                                               {60, 49.95},
                                               {30, 50},
                                               {60, 50.05},
                                               {100, 50.1},
                                               {100, 100},
                                               {0, 100}});
    const auto fewer = nest::simplified({notched}, 0.5, 3);
    EXPECT_FALSE(nest::doRingsCross(fewer));
    EXPECT_GE(geometry::signedAreaOf(fewer.front()), geometry::signedAreaOf(notched));
}

/// The nest is of the shape itself: of one whose sides lie on the strip's edges, as wide as it.
TEST(Simplify, ManyPointsAreLaidAsExactlyAsFew) {
    Polygon ring(400, 2);
    for (int k = 0; k < 100; ++k) {
        const double t = k / 100.0;
        ring.row(k) << 40 * t, std::sin(2 * kPi * t) + 1;
        ring.row(100 + k) << 40, 1 + 28 * t;
        ring.row(200 + k) << 40 - 40 * t, 29 - std::sin(2 * kPi * t);
        ring.row(300 + k) << 0, 29 - 28 * t;
    }
    ring.row(25) << 10, 0;  // touches both edges
    ring.row(75) << 30, 2;
    NestInstance instance{"many", 31, {test::nestItem("wave", ring, 6)}};
    instance.items[0].angles = {0, kPi};
    NestOptions options;
    options.evaluations = 3000;
    auto nester = Nester::make(instance, options);
    ASSERT_TRUE(nester.ok()) << sentence(nester.error());
    test::expectKeepsRules(instance, options, nester->best());
    const Progress progress;
    nester->step(progress);
    nester->step(progress);
    test::expectKeepsRules(instance, options, nester->best());
}

}  // namespace
