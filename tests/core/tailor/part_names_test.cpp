// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/part_names.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

/// The mean of each part's vertices, by the name that it gets.
std::map<std::string, Eigen::Vector3d> partsByName(const Pieces& pieces,
                                                   const std::vector<UserCut>& own = {},
                                                   bool isFrontSwapped = false) {
    const CutPieces made = cutPieces(
        pieces, own, true, Progress(), {},
        {[isFrontSwapped](const auto& piece, const auto& drawn, const Progress& progress) {
            ProposedCuts proposed;
            const auto body = readBody(piece, progress, isFrontSwapped);
            EXPECT_TRUE(body);
            const auto cuts = tailorCuts(*piece, *body, drawn, progress);
            for (const TailorCut& cut : cuts) {
                proposed.cuts.push_back({cut.cut, "from the shape"});
            }
            proposed.nameOf = [piece, body = *body, cuts](const Piece& part) {
                return partName(*piece, body, cuts, part);
            };
            return proposed;
        }});
    std::map<std::string, Eigen::Vector3d> middles;
    for (const auto& piece : made.pieces) {
        middles[piece->name] = piece->mesh.V.colwise().mean();
        EXPECT_FALSE(piece->defect) << piece->name;
    }
    EXPECT_EQ(middles.size(), made.pieces.size());
    return middles;
}

// Whoever wears the shapes looks along z, so that his left is where x is positive.

TEST(PartNames, OfAShirt) {
    const auto parts = partsByName({test::wornPiece(test::wornShirt())});
    ASSERT_EQ(parts.size(), 4U);
    EXPECT_GT(parts.at("front").z(), 30);
    EXPECT_LT(parts.at("back").z(), -30);
    EXPECT_GT(parts.at("left sleeve").x(), 200);
    EXPECT_LT(parts.at("right sleeve").x(), -200);
}

TEST(PartNames, OfTrousers) {
    const auto parts = partsByName({test::wornPiece(test::wornTrousers())});
    ASSERT_EQ(parts.size(), 4U);
    EXPECT_GT(parts.at("left leg front").x(), 0);
    EXPECT_GT(parts.at("left leg front").z(), 0);
    EXPECT_LT(parts.at("left leg back").z(), 0);
    EXPECT_LT(parts.at("right leg front").x(), 0);
    EXPECT_TRUE(parts.contains("right leg back"));
}

TEST(PartNames, FrontAndLeftChangeWhereThePersonSaysSo) {
    const auto parts = partsByName({test::wornPiece(test::wornShirt())}, {}, true);
    EXPECT_LT(parts.at("front").z(), -30);
    EXPECT_LT(parts.at("left sleeve").x(), -200);
}

TEST(PartNames, HalvesOfAFrontHaveTheirSide) {
    UserCut own;
    own.name = "opening";
    own.points = {{0, 520, 80}, {0, 0, 80}};
    const auto parts = partsByName({test::wornPiece(test::wornShirt())}, {own});
    EXPECT_GT(parts.at("left front").x(), 50);
    EXPECT_LT(parts.at("right front").x(), -50);
    EXPECT_TRUE(parts.contains("back"));
}

TEST(PartNames, AStripAlongAnOpeningIsItsBand) {
    UserCut belt;
    belt.name = "belt";
    belt.kind = UserCut::Kind::Loop;
    belt.points = {{0, 560, 87}, {163, 560, 0}, {0, 560, -87}, {-163, 560, 0}};
    const auto parts = partsByName({test::wornPiece(test::wornSkirt())}, {belt});
    EXPECT_TRUE(parts.contains("front") && parts.contains("back"));
    EXPECT_TRUE(parts.contains("waistband front") && parts.contains("waistband back"));
}

TEST(PartNames, OfSeveralGarmentsTellWhose) {
    MeshArrays below = test::wornSkirt();
    below.V.col(1).array() -= 700;
    auto skirt = std::make_shared<Piece>(*test::wornPiece(below));
    skirt->name = "skirt";
    auto shirt = std::make_shared<Piece>(*test::wornPiece(test::wornShirt()));
    shirt->name = "shirt";
    const auto parts = partsByName({shirt, skirt});
    EXPECT_TRUE(parts.contains("shirt, left sleeve") && parts.contains("skirt, front"));
}

}  // namespace
}  // namespace toile
