// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include <gtest/gtest.h>

#include "core/layout/arrange.h"

namespace toile {
namespace {

PatternPiece rectangle(double width, double height, const std::string& material) {
    PatternPiece piece;
    piece.name = piece.slug = "piece";
    piece.material = material;
    piece.outline.resize(4, 2);
    piece.outline << 0, 0, width, 0, width, height, 0, height;
    return piece;
}

std::optional<Placement> at(double x, double y) {
    Placement placement;
    placement.offset = {x, y};
    return placement;
}

TEST(ClothNeed, IsTheBoxOfWhatIsCutFromEachCloth) {
    Pattern pattern;
    pattern.materials = {{"Lining", *fabricPreset("jersey")}, {"Unused", {}}};
    pattern.pieces = {rectangle(300, 400, ""), rectangle(100, 200, "Lining"),
                      rectangle(300, 400, ""), PatternPiece{}};  // the last is not flat
    const auto needs =
        clothNeeds(cutAndPlace(pattern, {at(0, 0), at(0, 5000), at(1250, 100), std::nullopt}),
                   *fabricPreset("denim"));
    ASSERT_EQ(needs.size(), 2U);
    EXPECT_EQ(needs[0], (ClothNeed{"", 500, 1550, fabricPreset("denim")->width}));
    EXPECT_FALSE(needs[0].fits());
    EXPECT_EQ(needs[1], (ClothNeed{"Lining", 200, 100, fabricPreset("jersey")->width}));
    EXPECT_TRUE(needs[1].fits());
}

TEST(ClothNeed, GoesByTheLineThatIsCut) {
    Pattern pattern;
    pattern.pieces = {rectangle(300, 400, "")};
    pattern.pieces[0].cuttingLine.resize(4, 2);
    pattern.pieces[0].cuttingLine << -10, -30, 310, -30, 310, 410, -10, 410;
    const auto needs = clothNeeds(cutAndPlace(pattern), Fabric{});
    ASSERT_EQ(needs.size(), 1U);
    EXPECT_DOUBLE_EQ(needs[0].length, 440);
    EXPECT_DOUBLE_EQ(needs[0].across, 320);
    EXPECT_TRUE(sentence(needs[0]).starts_with("440 mm of cloth 1400 mm wide"));
}

TEST(ClothNeed, NothingFlatNeedsNothing) {
    Pattern pattern;
    pattern.pieces.resize(2);
    EXPECT_TRUE(clothNeeds(cutAndPlace(pattern), Fabric{}).empty());
}

}  // namespace
}  // namespace toile
