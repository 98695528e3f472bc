// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <gtest/gtest.h>

#include "core/symmetry/mirrored_pair.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

using Counterparts = std::vector<int>;

MirrorPieces pairsOf(const Garment& garment) {
    const auto plane = findMirrorPlane(garment.pieces);
    EXPECT_TRUE(plane);
    return pairPieces(garment, plane.value_or(MirrorPlane{}));
}

TEST(MirrorPieces, SidesArePairedAndTheMiddleIsItsOwn) {
    for (const Garment& garment : {test::tube4(), test::tube4(test::draped),
                                   test::tube4(test::moved), test::tube4(test::draped, 37)}) {
        EXPECT_EQ(pairsOf(garment).counterpart, (Counterparts{0, 3, 2, 1}));
        EXPECT_EQ(pairsOf(test::inOppositeOrder(garment)).counterpart, (Counterparts{2, 1, 0, 3}));
    }
}

TEST(MirrorPieces, SaysHowFarThePairsDiffer) {
    for (const double deviation : pairsOf(test::tube4()).deviation) {
        EXPECT_LT(deviation, 1e-3);
    }
    const MirrorPieces pairs = pairsOf(test::tube4(test::draped));
    EXPECT_EQ(pairs.deviation[1], pairs.deviation[3]);
    for (const double deviation : pairs.deviation) {
        EXPECT_GT(deviation, 0.1);
        EXPECT_LT(deviation, 8);
    }
}

TEST(MirrorPieces, APieceOnOneSideAloneHasNone) {
    Garment garment = test::tube4();
    garment.pieces.pop_back();  // the right side
    const MirrorPieces pairs = pairPieces(garment, {{1, 0, 0}, 0});
    EXPECT_EQ(pairs.counterpart, (Counterparts{0, -1, 2}));
    EXPECT_EQ(pairs.deviation[1], 0);
}

TEST(MirrorPieces, OfNothing) {
    EXPECT_TRUE(pairPieces({}, {}).counterpart.empty());
}

class MirrorPiecesOfSample : public testing::TestWithParam<const char*> {};

TEST_P(MirrorPiecesOfSample, LeftAndRightByName) {
    const Garment garment = test::garmentOf(GetParam());
    const MirrorPieces pairs = pairsOf(garment);
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        ASSERT_GE(pairs.counterpart[p], 0) << garment.pieces[p]->name;
        std::string other = garment.pieces[p]->name;
        if (const auto at = other.find("_left"); at != std::string::npos) {
            other.replace(at, 5, "_right");
        } else if (const auto there = other.find("_right"); there != std::string::npos) {
            other.replace(there, 6, "_left");
        }
        EXPECT_EQ(garment.pieces[static_cast<std::size_t>(pairs.counterpart[p])]->name, other);
        EXPECT_LT(pairs.deviation[p], 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, MirrorPiecesOfSample,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj",
                                         "samples/trousers.obj", "samples/cap.obj",
                                         "samples/skirt.obj"));

TEST(MirrorPieces, OfADrapedShirt) {
    const char* const file = "garments/tee_sim.obj";
    TOILE_NEEDS_SHARED(test::dataFile(file));
    EXPECT_EQ(pairsOf(test::garmentOf(file)).counterpart, (Counterparts{2, 3, 0, 1, 4, 5}));
}

TEST(MirrorPieces, OfADrapedDress) {
    const char* const file = "garments/dress.obj";
    TOILE_NEEDS_SHARED(test::dataFile(file));
    EXPECT_EQ(pairsOf(test::garmentOf(file)).counterpart,
              (Counterparts{2, 3, 0, 1, 5, 4, 6, 8, 7, 9, 12, 11, 10}));
}

}  // namespace
}  // namespace toile
