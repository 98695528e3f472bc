// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the shapes and rules, a nest keeps them.
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/sanitized.h"
#include "core/base/units.h"
#include "tests/core/nest/nest_shapes.h"

namespace {

using namespace toile;

NestItem randomItem(nest::Random& random, int index) {
    const double size = random.between(10, 45);
    const int corners = 3 + static_cast<int>(random.below(12));
    const bool isConvex = random.below(3) == 0;
    const geometry::Polygon outline =
        test::nestStar(random, corners, isConvex ? size : size / 4, size);
    const int demand = 1 + static_cast<int>(random.below(3));
    NestItem item = test::nestItem("item " + std::to_string(index), outline, demand);
    if (random.below(4) == 0) {  // as seen from its middle, the hole is inside
        geometry::Polygon hole = item.rings[0] * 0.6;
        item.rings.push_back(hole);
    }
    switch (random.below(4)) {
        case 0:
            item.angles = {0, kPi};
            break;
        case 1:
            item.angles = {0, kPi / 2, kPi, 3 * kPi / 2};
            break;
        case 2:
            item.tolerance = random.below(2) == 0 ? 2 * kPi : 5 * kDegree;
            break;
        default:
            item.angles = {30 * kDegree};
    }
    item.mayMirror = random.below(3) == 0;
    return item;
}

/// Stripes, a repeat both ways, a rail along the middle, or a fold.
void addRule(nest::Random& random, double width, NestItem& item) {
    const Eigen::Vector2d anchor(random.between(-20, 20), random.between(-20, 20));
    const Eigen::Vector2d phase(random.between(-50, 50), random.between(-50, 50));
    switch (random.below(6)) {
        case 0:
            item.lattice = NestLattice{anchor, phase, {random.between(3, 40), 0}};
            break;
        case 1:
            item.lattice =
                NestLattice{anchor, phase, {random.between(3, 20), random.between(2, 9)}};
            break;
        case 2:
            item.lattice = NestLattice{{0, 0}, {0, width / 2}, {0, HUGE_VAL}};
            break;
        case 3:
            item.touchesEdge = true;
            break;
        default:
            break;
    }
}

void addObstacles(nest::Random& random, NestInstance& instance) {
    for (int k = 0; k < 3; ++k) {
        NestObstacle obstacle{"hole " + std::to_string(k), {}, {}};
        obstacle.rings = {test::nestStar(random, 3 + static_cast<int>(random.below(6)), 4, 25)};
        obstacle.rings[0].col(0).array() += random.between(0, 250);
        obstacle.rings[0].col(1).array() += random.between(0, instance.width);
        if (random.below(2) == 0) {
            obstacle.items = {0, static_cast<int>(random.below(6))};
        }
        instance.obstacles.push_back(std::move(obstacle));
    }
}

/// Wavy below and above.
void addHide(nest::Random& random, NestInstance& instance) {
    const double wave = random.between(0, 4), length = 1500;
    geometry::Polygon hide(20, 2);
    for (int k = 0; k < 10; ++k) {
        hide.row(k) << length * k / 9, k % 2 == 0 ? 0 : wave;
        hide.row(19 - k) << length * k / 9, instance.width - (k % 2 == 0 ? wave : 0);
    }
    geometry::Polygon around = test::nestRectangle(length + 20, instance.width + 20);
    around.array() -= 10;
    instance.obstacles.push_back({"hide", {around, hide}, {}});
}

void addBands(nest::Random& random, NestInstance& instance) {
    const double sheet = random.between(125, 200), between = random.between(0, 30);
    for (int k = 1; k < 8; ++k) {
        instance.bands.push_back({k * (sheet + between) - between, k * (sheet + between)});
    }
}

void addFixed(nest::Random& random, NestInstance& instance) {
    NestItem item = randomItem(random, 6);
    item.demand = 1;
    item.fixed = NestPlacement{6, random.between(-4, 4), false, random.between(65, 80), 60};
    instance.items.push_back(std::move(item));
}

/// Six kinds of shapes, and what else there is to keep.
NestInstance randomInstance(nest::Random& random) {
    NestInstance instance{"random", random.between(125, 170), {}};
    for (int i = 0; i < 6; ++i) {
        instance.items.push_back(randomItem(random, i));
    }
    if (random.below(2) == 0) {
        for (NestItem& item : instance.items) {
            addRule(random, instance.width, item);
        }
    }
    if (random.below(3) == 0) {
        addObstacles(random, instance);
    }
    if (random.below(4) == 0) {
        addHide(random, instance);
    }
    if (random.below(3) == 0) {
        addBands(random, instance);
    }
    if (random.below(3) == 0) {
        addFixed(random, instance);
    }
    return instance;
}

class RandomNests : public testing::TestWithParam<int> {};

TEST_P(RandomNests, KeepTheRules) {
    const int sets = isSanitized() ? 2 : 10;  // of 500
    for (int k = 0; k < sets; ++k) {
        SCOPED_TRACE("set " + std::to_string(k));
        nest::Random random(static_cast<std::uint64_t>(GetParam()), static_cast<std::uint64_t>(k),
                            3);
        NestInstance instance = randomInstance(random);
        NestOptions options;
        options.gap = random.below(2) == 0 ? 0 : random.between(0.5, 4);
        options.border = random.below(2) == 0 ? 0 : random.between(0, 8);
        options.evaluations = 800;
        auto nester = Nester::make(instance, options);
        if (!nester.ok() && instance.items.back().fixed) {  // on an obstacle, or in a band
            EXPECT_EQ(nester.error().subject.name, instance.items.back().name);
            instance.items.pop_back();
            nester = Nester::make(instance, options);
        }
        ASSERT_TRUE(nester.ok()) << sentence(nester.error());
        test::expectKeepsRules(instance, options, nester->best());
        const Progress progress;
        for (int round = 0; round < 4; ++round) {
            nester->step(progress);
        }
        test::expectKeepsRules(instance, options, nester->best());
        options.threads = 1 + k % 5;
        auto again = Nester::make(instance, options);
        ASSERT_TRUE(again.ok());
        again->step(progress);
        again->step(progress);
        again->step(progress);
        again->step(progress);
        EXPECT_EQ(again->best().placements, nester->best().placements);
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, RandomNests, testing::Range(0, 4));
INSTANTIATE_TEST_SUITE_P(Slow, RandomNests, testing::Range(4, 50));

}  // namespace
