// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/nest.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/nest/nest_shapes.h"

namespace {

using namespace toile;
using test::nestItem;
using test::nestPolygon;
using test::nestRectangle;

Nester nesterOf(const NestInstance& instance, const NestOptions& options = {}) {
    auto nester = Nester::make(instance, options);
    EXPECT_TRUE(nester.ok()) << sentence(nester.error());
    return std::move(*nester);
}

NestResult nested(const NestInstance& instance, int rounds, const NestOptions& options = {}) {
    Nester nester = nesterOf(instance, options);
    const Progress progress;
    while (nester.best().rounds < rounds) {
        nester.step(progress);
    }
    return nester.best();
}

NestOptions quick() {
    NestOptions options;
    options.evaluations = 5000;
    return options;
}

/// Three kinds of triangles and an angle piece.
NestInstance mixedInstance() {
    NestInstance instance{"mixed", 100, {}};
    instance.items = {
        nestItem("a", nestPolygon({{0, 0}, {40, 0}, {10, 30}}), 5),
        nestItem("b", nestPolygon({{0, 0}, {25, 5}, {5, 45}}), 4),
        nestItem("c", nestPolygon({{0, 0}, {50, 0}, {50, 15}, {15, 15}, {15, 40}, {0, 40}}), 3)};
    for (NestItem& item : instance.items) {
        item.angles = {0, kPi};
    }
    return instance;
}

TEST(Nest, SquaresFillTheStrip) {
    NestInstance instance{"squares", 30, {nestItem("square", nestRectangle(10, 10), 12)}};
    const NestResult result = nested(instance, 0);
    EXPECT_EQ(result.length, 40);
    EXPECT_EQ(result.use, 1);
    EXPECT_TRUE(result.optimal);
    test::expectKeepsRules(instance, {}, result);
}

TEST(Nest, TwoRightTrianglesMakeARectangle) {
    NestInstance instance{
        "triangles", 30, {nestItem("t", nestPolygon({{0, 0}, {40, 0}, {0, 30}}), 2)}};
    instance.items[0].angles = {0, kPi};
    const NestResult result = nested(instance, 10, quick());
    EXPECT_GT(result.use, 0.98);
    test::expectKeepsRules(instance, {}, result);
}

TEST(Nest, ASquareFindsAHole) {
    NestInstance instance{
        "frame",
        100,
        {nestItem("frame", nestRectangle(100, 100)), nestItem("square", nestRectangle(50, 50))}};
    instance.items[0].rings.push_back(nestPolygon({{20, 20}, {80, 20}, {80, 80}, {20, 80}}));
    const NestResult result = nested(instance, 10, quick());
    EXPECT_EQ(result.length, 100);
    test::expectKeepsRules(instance, {}, result);
}

TEST(Nest, DependsOnRoundsAndNotOnThreads) {
    NestOptions options = quick();
    options.searches = 5;
    std::vector<NestResult> results;
    for (const int threads : {1, 2, 5}) {
        options.threads = threads;
        results.push_back(nested(mixedInstance(), 6, options));
        EXPECT_EQ(results.back().placements, results.front().placements) << threads;
        EXPECT_EQ(results.back().length, results.front().length) << threads;
    }
    options.seed = 2;
    EXPECT_NE(nested(mixedInstance(), 6, options).placements, results.front().placements);
}

TEST(Nest, IsNeverLongerAfterMoreRounds) {
    const NestInstance instance = mixedInstance();
    Nester nester = nesterOf(instance, quick());
    const Progress progress;
    const double first = nester.best().length;
    for (int k = 0; k < 12; ++k) {
        const double before = nester.best().length;
        nester.step(progress);
        EXPECT_LE(nester.best().length, before);
        EXPECT_EQ(nester.best().rounds, k + 1);
    }
    EXPECT_LT(nester.best().length, first);
    test::expectKeepsRules(instance, {}, nester.best());
}

TEST(Nest, CancelKeepsTheBest) {
    Nester nester = nesterOf(mixedInstance(), quick());
    Progress progress;
    nester.step(progress);
    const NestResult before = nester.best();
    progress.cancel();
    nester.step(progress);
    EXPECT_EQ(nester.best().placements, before.placements);
    EXPECT_EQ(nester.best().rounds, 1);
}

TEST(Nest, WhatIsWiderThanTheStripIsNamed) {
    NestInstance instance{
        "narrow",
        30,
        {nestItem("sleeve", nestRectangle(20, 10)), nestItem("back", nestRectangle(40, 31))}};
    const auto nester = Nester::make(instance, {});
    ASSERT_FALSE(nester.ok());
    EXPECT_EQ(nester.error().code, ErrorCode::PageTooSmall);
    EXPECT_EQ(nester.error().subject.name, "back");
    NestOptions bordered;
    bordered.border = 10.5;
    EXPECT_EQ(Nester::make({"narrow", 30, {nestItem("sleeve", nestRectangle(20, 10))}}, bordered)
                  .error()
                  .subject.name,
              "sleeve");
    instance.items[1].angles = {0, kPi / 2};
    EXPECT_FALSE(Nester::make(instance, {}).ok());
    instance.width = 31;
    EXPECT_TRUE(Nester::make(instance, {}).ok());
}

TEST(Nest, WhatIsNoShapeIsNamed) {
    NestItem line = nestItem("line", nestPolygon({{0, 0}, {1, 1}, {2, 2}}));
    NestItem gap = nestItem("gap", nestRectangle(10, 10));
    gap.rings[0](1, 0) = std::nan("");
    NestItem still = nestItem("still", nestRectangle(10, 10));
    still.angles.clear();
    NestItem knot = nestItem("knot", nestPolygon({{0, 0}, {10, 20}, {10, 0}, {0, 10}}));
    NestItem holed = nestItem("holed", nestRectangle(10, 10));
    holed.rings.push_back(nestPolygon({{5, 5}, {15, 5}, {5, 8}}));
    NestItem sliver = nestItem("sliver", nestRectangle(10, 1e-4));
    const NestItem owed = nestItem("owed", nestRectangle(10, 10), -1);
    NestItem far = nestItem("far", nestRectangle(10, 10));
    far.fixed = NestPlacement{0, 0, false, 1e12, 0};
    NestItem lost = far;
    lost.name = "lost";
    lost.fixed->x = std::nan("");
    for (const NestItem& item : {line, gap, still, knot, holed, sliver, owed, far, lost,
                                 nestItem("none", geometry::Polygon())}) {
        const auto nester =
            Nester::make({"bad", 30, {nestItem("good", nestRectangle(5, 5)), item}}, {});
        ASSERT_FALSE(nester.ok()) << item.name;
        EXPECT_EQ(nester.error().code, ErrorCode::MalformedFile);
        EXPECT_EQ(nester.error().subject.name, item.name);
    }
}

TEST(Nest, WhatHasNoCopiesIsAskedNothing) {
    NestItem none = nestItem("none", geometry::Polygon(), 0);
    const NestInstance instance{"some", 30, {none, nestItem("good", nestRectangle(5, 5)), none}};
    const NestResult result = nested(instance, 1, quick());
    ASSERT_EQ(result.placements.size(), 1U);
    EXPECT_EQ(result.placements[0].item, 1);
    EXPECT_TRUE(nested({"none", 30, {none}}, 0).optimal);
}

TEST(Nest, PointsThatRepeatChangeNothing) {
    NestInstance instance = mixedInstance();
    const NestResult result = nested(instance, 2, quick());
    instance.items[0].rings[0] =
        nestPolygon({{0, 0}, {0, 0}, {40, 0}, {10, 30}, {10, 30}, {10, 30}, {0, 0}});
    EXPECT_EQ(nested(instance, 2, quick()).placements, result.placements);
}

TEST(Nest, MoreCopiesThanAreLaidAtOnceAreRefused) {
    const auto nester = Nester::make(
        {"crowd",
         30,
         {nestItem("a", nestRectangle(5, 5), 2000), nestItem("b", nestRectangle(5, 5), 2001)}},
        {});
    ASSERT_FALSE(nester.ok());
    EXPECT_EQ(nester.error().code, ErrorCode::MalformedFile);
    EXPECT_EQ(nester.error().subject.name, "crowd");
}

TEST(Nest, TheFirstNestHearsCancel) {
    Progress progress;
    progress.cancel();
    EXPECT_EQ(Nester::make(mixedInstance(), {}, progress).error().code, ErrorCode::Cancelled);
}

/// Alone it collides with nothing, and still looks for a turn that is short along the strip.
TEST(Nest, TheFirstNestCanBeLaidInHaste) {
    NestInstance instance = mixedInstance();
    instance.items[0].tolerance = 0.2;
    instance.obstacles.push_back({"hole", {nestRectangle(20, 30)}, {}});
    NestOptions hasty = quick();
    hasty.hasteAfter = 1e-9;  // from the start
    const NestResult result = nested(instance, 0, hasty);
    EXPECT_TRUE(result.valid);
    test::expectKeepsRules(instance, hasty, result);
    // Then rounds improve it like any other.
    EXPECT_LE(nested(instance, 3, hasty).length, result.length);
    instance.bands.push_back({400, HUGE_VAL});  // the cloth ends
    EXPECT_TRUE(nested(instance, 0, hasty).valid);
}

TEST(Nest, ShapesOfManyCornersAreLaid) {
    nest::Random random(3);
    NestInstance instance{
        "stars", 500, {nestItem("star", test::nestStar(random, 5000, 50, 200), 3)}};
    const NestResult result = nested(instance, 0);
    EXPECT_TRUE(result.valid);
    EXPECT_EQ(result.placements.size(), 3U);
}

TEST(Nest, ALoneCopyTurnsToItsBestAngle) {
    NestInstance instance{"lone", 80, {nestItem("long", nestRectangle(100, 10))}};
    instance.items[0].tolerance = kPi;
    const NestResult result = nested(instance, 10, quick());
    // Its diagonal across the strip: 100 cos t + 10 sin t, where 100 sin t + 10 cos t = 80.
    const double turn = std::asin(80 / std::hypot(100.0, 10.0)) - std::atan2(10.0, 100.0);
    const double least = 100 * std::cos(turn) + 10 * std::sin(turn);
    EXPECT_GE(result.length, least - 1e-9);
    EXPECT_LE(result.length, least * 1.02);
    test::expectKeepsRules(instance, {}, result);
}

TEST(Nest, AFixedCopyStays) {
    NestInstance instance = mixedInstance();
    instance.items[2].demand = 1;
    instance.items[2].fixed = NestPlacement{2, kPi, false, 120, 70};
    const NestResult result = nested(instance, 6, quick());
    EXPECT_EQ(result.placements.back(), *instance.items[2].fixed);
    test::expectKeepsRules(instance, {}, result);

    instance.items.push_back(nestItem("on it", nestRectangle(10, 10)));
    instance.items[3].fixed = NestPlacement{3, 0, false, 100, 58};
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "on it");
    instance.items[3].fixed->x = -1;
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "on it");
}

TEST(Nest, NothingIsLaidOnNothing) {
    const NestResult result = nested({"empty", 100, {}}, 2);
    EXPECT_TRUE(result.valid && result.optimal);
    EXPECT_EQ(result.length, 0);
}

}  // namespace
