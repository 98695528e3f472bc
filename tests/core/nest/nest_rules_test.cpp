// SPDX-License-Identifier: GPL-3.0-or-later
// Cloth with holes, sheets, hides, stripes and a fold.
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

/// After a few short rounds.
NestResult laid(const NestInstance& instance, NestOptions options = {}) {
    options.evaluations = 5000;
    auto nester = Nester::make(instance, options);
    EXPECT_TRUE(nester.ok()) << sentence(nester.error());
    const Progress progress;
    for (int k = 0; k < 5 && nester.ok(); ++k) {
        nester->step(progress);
    }
    test::expectKeepsRules(instance, options, nester->best());
    return nester->best();
}

geometry::Polygon disc(double radius, double x, double y) {
    geometry::Polygon ring(40, 2);
    for (int k = 0; k < 40; ++k) {
        ring.row(k) << x + radius * std::cos(2 * kPi * k / 40),
            y + radius * std::sin(2 * kPi * k / 40);
    }
    return ring;
}

TEST(NestRules, WhatIsCutFromAHideLiesInIt) {
    NestInstance instance{"hide", 200, {nestItem("square", nestRectangle(30, 30), 15)}};
    geometry::Polygon around = nestRectangle(220, 220);
    around.array() -= 10;
    instance.obstacles = {{"hide", {around, disc(100, 100, 100)}, {}},
                          {"brand", {disc(10, 60, 60)}, {}}};
    instance.bands = {{200, HUGE_VAL}};
    laid(instance);
    NestOptions apart;
    apart.border = 3;
    apart.gap = 2;
    laid(instance, apart);
    instance.items[0].demand = 40;  // of more area than there is
    const auto nester = Nester::make(instance, {});
    ASSERT_FALSE(nester.ok());
    EXPECT_EQ(nester.error().code, ErrorCode::PageTooSmall);
    EXPECT_EQ(nester.error().subject.name, "square");
}

TEST(NestRules, AZoneIsForbiddenToThoseItNames) {
    NestInstance instance{
        "zone",
        30,
        {nestItem("fine", nestRectangle(10, 30)), nestItem("lining", nestRectangle(10, 30))}};
    instance.obstacles = {{"scar", {nestRectangle(12, 30)}, {0}}};
    const NestResult result = laid(instance);
    EXPECT_EQ(result.placements[0].x, 12);
    EXPECT_EQ(result.placements[1].x, 0);
    EXPECT_EQ(result.length, 22);
}

TEST(NestRules, WhatFitsNoMoreOnASheetLiesOnTheNext) {
    NestInstance instance{"sheets", 30, {nestItem("square", nestRectangle(10, 10), 12)}};
    instance.bands = {{90, 100}, {35, 50}};
    const NestResult result = laid(instance);
    EXPECT_EQ(result.length, 60);
    EXPECT_EQ(std::ranges::count_if(result.placements, [](const auto& p) { return p.x < 35; }), 9);
    instance.items[0].rings = {nestRectangle(38, 10)};
    EXPECT_GE(laid(instance).length, 100);  // too long for the first
}

TEST(NestRules, ClothMayEnd) {
    NestInstance instance{"end", 30, {nestItem("square", nestRectangle(10, 10), 30)}};
    instance.bands = {{100, HUGE_VAL}};
    EXPECT_EQ(laid(instance).length, 100);
    instance.items[0].demand = 31;
    const auto full = Nester::make(instance, {});
    ASSERT_FALSE(full.ok());
    EXPECT_EQ(full.error().code, ErrorCode::PageTooSmall);
    EXPECT_EQ(full.error().subject.name, "square");
    instance.items.push_back(nestItem("long", nestRectangle(101, 10)));
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "long");
}

/// One after the other leaves no room for the last ones; pushing them apart does.
TEST(NestRules, CrowdedClothIsFilledBySearch) {
    NestInstance instance{
        "crowd", 30, {nestItem("half", nestPolygon({{0, 0}, {40, 0}, {0, 30}}), 6)}};
    instance.items[0].angles = {0, kPi};
    instance.bands = {{124, HUGE_VAL}};
    EXPECT_LE(laid(instance).length, 124);
}

TEST(NestRules, WhatHasItsPlaceInTheRepeatLiesThere) {
    NestInstance instance{"stripes", 60, {nestItem("front", nestRectangle(13, 20), 6)}};
    instance.items[0].angles = {0, kPi};
    instance.items[0].lattice = NestLattice{{6.5, 4}, {2, 1}, {10, 5}};
    EXPECT_GE(laid(instance).length, 33);
    instance.items[0].lattice->step = {HUGE_VAL, 0};
    EXPECT_FALSE(Nester::make(instance, {}).ok());  // its middle 2 from the end
    instance.items[0].lattice->phase.x() = 7;
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "front");  // six in one column
    instance.items[0].demand = 3;
    EXPECT_EQ(laid(instance).length, 13.5);
}

/// Its neighbour ends where the next place on the track is, but for less than counts as off it.
TEST(NestRules, APlaceOnTheTrackIsTriedOnce) {
    NestInstance instance{"stripes", 60, {nestItem("front", nestRectangle(10.0000003, 60), 3)}};
    instance.items[0].lattice = NestLattice{{0, 0}, {0, 0}, {10, 0}};
    EXPECT_NEAR(laid(instance).length, 50, 1e-3);
}

TEST(NestRules, OnTheFoldNoBorderIsKept) {
    NestInstance instance{
        "fold",
        50,
        {nestItem("back", nestRectangle(30, 20), 2), nestItem("sleeve", nestRectangle(15, 15), 4)}};
    instance.items[0].touchesEdge = true;
    instance.items[0].mayMirror = true;
    NestOptions options;
    options.border = 4;
    options.gap = 2;
    const NestResult result = laid(instance, options);
    EXPECT_EQ(result.placements[0].y, 0);
    EXPECT_LE(result.length, 74.1);  // four sleeves above both
}

TEST(NestRules, WhatIsNoShapeOrClothIsNamed) {
    const geometry::Polygon square = nestRectangle(10, 10);
    NestItem twice = nestItem(
        "bad", nestPolygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}}));
    NestItem outside = nestItem("bad", square);
    outside.rings.push_back(nestPolygon({{20, 0}, {25, 0}, {25, 5}}));
    NestItem within = nestItem("bad", square);
    within.rings.push_back(nestPolygon({{1, 1}, {8, 1}, {8, 8}, {1, 8}}));
    within.rings.push_back(nestPolygon({{2, 2}, {6, 2}, {6, 6}}));
    NestItem lost = nestItem("bad", square);
    lost.lattice = NestLattice{{0, 0}, {0, std::nan("")}, {1, 1}};
    for (const NestItem& item : {twice, outside, within, lost}) {
        const auto nester = Nester::make({"cloth", 30, {nestItem("good", square), item}}, {});
        ASSERT_FALSE(nester.ok());
        EXPECT_EQ(nester.error().code, ErrorCode::MalformedFile);
        EXPECT_EQ(nester.error().subject.name, "bad");
    }
    NestInstance instance{"cloth", 30, {nestItem("good", square)}};
    instance.obstacles = {{"hole", twice.rings, {}}};
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "hole");
    instance.obstacles.clear();
    instance.bands = {{20, 10}};
    EXPECT_EQ(Nester::make(instance, {}).error().subject.name, "cloth");
}

/// Whatever points a ring has, it is refused by name or laid as the rules say.
TEST(NestRules, AnyRingsAreRefusedOrLaid) {
    int count = 0;
    nest::Random random(5);
    for (int k = 0; k < 400; ++k) {
        NestItem item = nestItem("any", geometry::Polygon(), 2);
        item.rings.clear();
        const std::size_t rings = 1 + random.below(3);
        for (std::size_t ring = 0; ring < rings; ++ring) {
            geometry::Polygon points(static_cast<Eigen::Index>(3 + random.below(4)), 2);
            for (Eigen::Index p = 0; p < points.rows(); ++p) {
                points.row(p) << static_cast<double>(random.below(6)),
                    static_cast<double>(random.below(6));
            }
            item.rings.push_back(ring == 0 ? points : geometry::Polygon(points / 3));
        }
        const NestInstance instance{"cloth", 9, {item}};
        auto nester = Nester::make(instance, {});
        if (!nester.ok()) {
            EXPECT_EQ(nester.error().subject.name, "any") << sentence(nester.error());
            continue;
        }
        ++count;
        test::expectKeepsRules(instance, {}, nester->best());
    }
    EXPECT_GT(count, 50);
}

}  // namespace
