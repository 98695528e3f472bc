// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the shapes and rules, a nest keeps them.
#include <gtest/gtest.h>

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

class RandomNests : public testing::TestWithParam<int> {};

TEST_P(RandomNests, KeepTheRules) {
    for (int k = 0; k < 10; ++k) {
        nest::Random random(static_cast<std::uint64_t>(GetParam()), static_cast<std::uint64_t>(k),
                            3);
        NestInstance instance{"random", random.between(110, 160), {}};
        for (int i = 0; i < 6; ++i) {
            instance.items.push_back(randomItem(random, i));
        }
        NestOptions options;
        options.gap = random.below(2) == 0 ? 0 : random.between(0.5, 4);
        options.border = random.below(2) == 0 ? 0 : random.between(0, 8);
        options.evaluations = 1500;
        auto nester = Nester::make(instance, options);
        ASSERT_TRUE(nester.ok()) << sentence(nester.error());
        test::expectKeepsRules(instance, options, nester->best());
        const Progress progress;
        for (int round = 0; round < 4; ++round) {
            nester->step(progress);
        }
        test::expectKeepsRules(instance, options, nester->best());
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, RandomNests, testing::Range(0, 10));

}  // namespace
