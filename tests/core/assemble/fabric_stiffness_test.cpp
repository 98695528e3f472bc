// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/fabric_stiffness.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(FabricStiffness, OfEveryPresetResistsEveryStrain) {
    for (const Fabric& fabric : fabricPresets()) {
        const ClothStiffness cloth = clothStiffness(fabric);
        EXPECT_GT(cloth.weft * cloth.warp, cloth.coupling * cloth.coupling) << fabric.id;
        EXPECT_TRUE(cloth.weft > 0 && cloth.warp > 0 && cloth.shear > 0) << fabric.id;
        EXPECT_TRUE(cloth.bending > 0 && cloth.weight > 0) << fabric.id;
        EXPECT_EQ(cloth == kUnstatedStiffness, !hasLimits(fabric)) << fabric.id;
    }
}

TEST(FabricStiffness, OfAPersonsOwnFabricIsAlikeInAllDirections) {
    const ClothStiffness cloth = clothStiffness({"custom", {0, 0.1}, {0, 0.2}, {0, 0.3}});
    EXPECT_EQ(cloth, kUnstatedStiffness);
    EXPECT_EQ(cloth.warp, cloth.weft);
}

TEST(FabricStiffness, WhatIsStatedTakesThePlaceOfTheFabrics) {
    const ClothStiffness denim = clothStiffness(*fabricPreset("denim"));
    EXPECT_EQ(StatedStiffness{}.over(denim), denim);
    StatedStiffness stated;
    stated.warp = 4 * denim.warp;
    stated.bending = 0;
    const ClothStiffness made = stated.over(denim);
    EXPECT_EQ(made.warp, 4 * denim.warp);
    EXPECT_EQ(made.weft, denim.weft);
    EXPECT_EQ(made.bending, 0);
    EXPECT_EQ(made.weight, denim.weight);
    EXPECT_DOUBLE_EQ(made.coupling, 2 * denim.coupling);  // as its share of both
}

}  // namespace
}  // namespace toile
