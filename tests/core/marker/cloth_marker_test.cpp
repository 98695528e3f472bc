// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_marker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/marker/cloth_fit.h"
#include "tests/core/marker/marker_fixtures.h"

namespace toile {
namespace {

using test::clothPattern;
using test::clothPiece;
using test::laidOn;

TEST(ClothMarker, LaysEachPieceAsOftenAsItIsCutInPairs) {
    Pattern pattern =
        clothPattern({clothPiece("back", 300, 500, 1), clothPiece("sleeve", 200, 300, 2),
                      clothPiece("none", 200, 300, 3)});
    pattern.pieces[1].quantity = 2;
    pattern.pieces[1].mirroredPair = true;
    pattern.pieces[2].quantity = 0;
    MarkerSettings settings;
    settings.garments = 3;
    const ClothMarker marker = laidOn(900, pattern, settings);
    std::map<std::pair<int, bool>, int> counts;
    std::map<CopyKey, int> keys;
    for (const LaidCopy& copy : marker.copies) {
        ++counts[{copy.piece, copy.isImage}];
        ++keys[copy.key];
        EXPECT_EQ(copy.placement.mirrored, copy.isImage);
        // The warp, up the piece, runs along the cloth.
        EXPECT_NEAR(std::abs(std::cos(directionOnSheet(copy.placement, kGrainUpwards))), 1, 1e-12);
    }
    EXPECT_EQ(counts, (std::map<std::pair<int, bool>, int>{
                          {{0, false}, 3}, {{1, false}, 6}, {{1, true}, 6}}));
    EXPECT_EQ(keys.size(), marker.copies.size());
    EXPECT_GT(marker.use, 0.6);
    EXPECT_EQ(markerFigures(pattern, marker).copies, 15);
}

TEST(ClothMarker, TurnsNothingOnClothWithANap) {
    Pattern pattern = clothPattern({clothPiece("back", 300, 500, 1)});
    pattern.pieces[0].quantity = 4;
    pattern.pieces[0].mirroredPair = true;
    pattern.pieces[0].grain = 0.4;
    MarkerSettings settings;
    settings.turns = TurnRule::OneWay;
    for (const LaidCopy& copy : laidOn(1000, pattern, settings).copies) {
        EXPECT_NEAR(directionOnSheet(copy.placement, 0.4), 0, 1e-12);
    }
    settings.tolerance = 0.05;
    for (const LaidCopy& copy : laidOn(1000, pattern, settings).copies) {
        EXPECT_LE(std::abs(directionOnSheet(copy.placement, 0.4)), 0.05 + 1e-12);
    }
}

TEST(ClothMarker, KeptCopiesStay) {
    Pattern pattern = clothPattern({clothPiece("back", 300, 500, 1)});
    pattern.pieces[0].quantity = 2;
    pattern.pieces[0].mirroredPair = true;
    KeptCopy kept{{{1}, 3}};
    kept.placement = {{700, 350}, 0.3, true};
    const ClothMarker marker = laidOn(900, pattern, {}, {kept, {{{7}, 0}}, {{{1}, 9}}}, 3);
    ASSERT_EQ(marker.copies.size(), 4U);
    const auto found = std::ranges::find(marker.copies, kept.copy, &LaidCopy::key);
    ASSERT_NE(found, marker.copies.end());
    EXPECT_TRUE(found->isKept && found->isImage);
    EXPECT_EQ(found->placement, kept.placement);
    EXPECT_EQ(std::ranges::count(marker.copies, true, &LaidCopy::isKept), 1);
}

TEST(ClothMarker, NamesWhatIsTooWideAndLaysTheRest) {
    const Pattern pattern =
        clothPattern({clothPiece("Back", 1620, 700, 1), clothPiece("Front", 700, 600, 2)});
    const ClothMarker marker = laidOn(1400, pattern);
    ASSERT_EQ(marker.copies.size(), 1U);
    EXPECT_EQ(marker.copies[0].piece, 1);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_EQ(marker.notes[0],
              "Back is not placed: it is 1620 mm across, but the cloth only 1400 mm; splice it at "
              "1390 mm");
}

TEST(ClothFit, NamesWhatTheMarkerLeavesOut) {
    const Pattern pattern =
        clothPattern({clothPiece("Back", 1620, 700, 1), clothPiece("Front", 700, 600, 2)});
    ClothRules rules;
    MarkerSettings& settings = rules[""];
    for (const auto& [width, border, wide] :
         {std::tuple(1620.5, 0.0, 0), std::tuple(1620.5, 1.0, 1), std::tuple(699.0, 0.0, 2)}) {
        Fabric cloth;
        cloth.width = width;
        settings.border = border;
        const auto found = widerThanCloth(pattern, cloth, rules);
        ASSERT_EQ(static_cast<int>(found.size()), wide) << width;
        if (wide > 0) {
            EXPECT_EQ(found[0].piece, 0);
            EXPECT_NEAR(found[0].extent, 1620, 1e-9);
            EXPECT_NEAR(found[0].room, width - 2 * border, 1e-9);
        }
    }
    settings = {};
    settings.isFolded = true;  // 700 mm, as wide as one of them
    EXPECT_EQ(widerThanCloth(pattern, Fabric{}, rules).size(), 1U);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_TRUE(widerThanCloth(pattern, Fabric{}, rules, cancelled).empty());
}

TEST(ClothFit, OfASheetTheLengthCountsToo) {
    const Pattern pattern =
        clothPattern({clothPiece("Back", 500, 900, 1), clothPiece("Front", 500, 700, 2)});
    ClothRules rules;
    MarkerSettings& settings = rules[""];
    settings.border = 5;
    settings.sheet = Eigen::Vector2d(800, 600);
    const auto found = widerThanCloth(pattern, Fabric{}, rules);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].piece, 0);
    EXPECT_NEAR(found[0].extent, 900, 1e-9);
    EXPECT_NEAR(found[0].room, 790, 1e-9);
    const ClothMarker marker = laidOn(600, pattern, settings);
    EXPECT_FALSE(marker.isWhole);
    ASSERT_EQ(marker.copies.size(), 1U);
    EXPECT_EQ(marker.copies[0].piece, 1);
}

TEST(ClothFit, AFacingIsNamedItself) {
    Pattern pattern = clothPattern({clothPiece("Front", 300, 600, 1)});
    FacingPiece facing;
    facing.piece = facing.facing = 0;
    facing.strip = clothPiece("Hem facing", 1620, 50, 0);
    pattern.facings.push_back(facing);
    const auto found = widerThanCloth(pattern, Fabric{}, {});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].piece, 0);
    EXPECT_EQ(found[0].facing, "Hem facing");
    EXPECT_NEAR(found[0].extent, 1620, 1e-9);
}

TEST(ClothMarker, AnOutlineThatCrossesItselfIsNamed) {
    Pattern pattern =
        clothPattern({clothPiece("bow", 100, 100, 1), clothPiece("Front", 70, 60, 2)});
    pattern.pieces[0].outline.resize(4, 2);
    pattern.pieces[0].outline << 0, 0, 100, 100, 100, 0, 0, 50;
    const ClothMarker marker = laidOn(1400, pattern);
    EXPECT_EQ(marker.copies.size(), 1U);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_TRUE(marker.notes[0].starts_with("bow ")) << marker.notes[0];
    EXPECT_NE(marker.notes[0].find("crosses itself"), std::string::npos);
}

TEST(ClothMarker, EachMaterialHasItsOwn) {
    Pattern pattern =
        clothPattern({clothPiece("Front", 70, 60, 2), clothPiece("Lining", 70, 60, 3)});
    pattern.materials = {{"Silk", {}}};
    pattern.pieces[1].material = "Silk";
    EXPECT_EQ(markerMaterials(pattern), (std::vector<std::string>{"", "Silk"}));
    const ClothMarker marker = laidOn(500, pattern, {}, {}, 1, "Silk");
    ASSERT_EQ(marker.copies.size(), 1U);
    EXPECT_EQ(marker.copies[0].piece, 1);
}

TEST(ClothMarker, PairsAreLaidOnceOnFoldedCloth) {
    Pattern pattern =
        clothPattern({clothPiece("sleeve", 200, 300, 1), clothPiece("pocket", 100, 90, 2)});
    pattern.pieces[0].mirroredPair = true;
    MarkerSettings settings;
    settings.isFolded = true;
    const ClothMarker marker = laidOn(900, pattern, settings);
    EXPECT_EQ(marker.width, 450);
    ASSERT_EQ(marker.copies.size(), 2U);
    EXPECT_EQ(markerFigures(pattern, marker).copies, 3);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_TRUE(marker.notes[0].starts_with("pocket ")) << marker.notes[0];
    EXPECT_NE(marker.notes[0].find(" 1 more than needed"), std::string::npos);
}

/// A piece that is its own image, of 2 x `half` by `height`.
PatternPiece symmetricPiece(double half, double height, std::uint64_t id) {
    PatternPiece piece;
    piece.name = piece.slug = "front";
    piece.id = {id};
    piece.mirror.isSymmetric = true;
    piece.outline.resize(6, 2);
    // The mirror line goes from row 0 to row 3, upwards, the first half on the right of it.
    piece.outline << 0, height, -half, height - 50, -half, 0, 0, 20, half, 0, half, height - 50;
    return piece;
}

TEST(ClothMarker, WhatMirrorsItselfLiesOnTheFold) {
    MarkerSettings settings;
    settings.isFolded = true;
    settings.border = 5;
    for (const TurnRule turns : {TurnRule::HalfTurns, TurnRule::OneWay}) {
        settings.turns = turns;
        Pattern whole = clothPattern({symmetricPiece(250, 700, 1), symmetricPiece(250, 600, 2)});
        const Pattern pattern = patternOnCloth(whole, settings);
        ASSERT_EQ(pattern.pieces[0].cutAs, CutAs::OnFold);
        const ClothMarker marker = laidOn(900, pattern, settings);
        ASSERT_EQ(marker.copies.size(), 2U);
        for (const LaidCopy& copy : marker.copies) {
            const Points2 line = laidOutline(pattern, copy);
            EXPECT_EQ(line.col(1).minCoeff(), 0);
            EXPECT_EQ((line.col(1).array() == 0).count(), 2);  // both ends of its fold
            EXPECT_NEAR(line.col(1).maxCoeff(), 250, 1e-9);
            if (turns == TurnRule::OneWay) {
                EXPECT_NEAR(directionOnSheet(copy.placement, kGrainUpwards), 0, 1e-12);
            }
        }
        EXPECT_EQ(markerFigures(pattern, marker).copies, 2);
    }
    settings.isFolded = false;
    const Pattern flat = patternOnCloth(clothPattern({symmetricPiece(250, 700, 1)}), settings);
    EXPECT_EQ(flat.pieces[0].cutAs, CutAs::Whole);
}

TEST(ClothMarker, WhatIsKeptOnOthersStaysAndTheRestMakesRoom) {
    Pattern pattern = clothPattern({clothPiece("back", 300, 500, 1)});
    pattern.pieces[0].quantity = 4;
    std::vector<KeptCopy> kept(2);
    kept[0] = {{{1}, 0}, 0, {{100, 100}, 0, false}};
    kept[1] = {{{1}, 2}, 0, {{150, 150}, 0, false}};
    auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), "", Fabric{}, {},
                                     kept, Progress());
    ASSERT_TRUE(nester) << sentence(nester.error());
    nester->step(Progress());
    const ClothMarker& marker = nester->best();
    EXPECT_EQ(marker.copies.size(), 4U);
    EXPECT_TRUE(marker.isWhole);
    const std::vector<int> misplaced = misplacedCopies(pattern, marker, {});
    ASSERT_EQ(misplaced.size(), 2U);
    for (const int copy : misplaced) {
        EXPECT_TRUE(marker.copies[static_cast<std::size_t>(copy)].isKept);
    }
}

TEST(ClothMarker, IsTheSameWithAnyNumberOfThreads) {
    Pattern pattern =
        clothPattern({clothPiece("back", 300, 500, 1), clothPiece("sleeve", 210, 300, 2)});
    pattern.pieces[1].quantity = 3;
    pattern.pieces[1].mirroredPair = true;
    const auto shared = std::make_shared<const Pattern>(pattern);
    std::vector<std::vector<Placement>> found;
    for (const int threads : {1, 2, 5}) {
        auto nester = MarkerNester::make(shared, "", Fabric{}, {}, {}, Progress(), threads);
        ASSERT_TRUE(nester);
        for (int k = 0; k < 3; ++k) {
            nester->step(Progress());
        }
        auto& places = found.emplace_back();
        for (const LaidCopy& copy : nester->best().copies) {
            places.push_back(copy.placement);
        }
    }
    EXPECT_EQ(found[0], found[1]);
    EXPECT_EQ(found[0], found[2]);
}

TEST(MisplacedCopies, LieOnOthersOrBeyondTheCloth) {
    const Pattern pattern = clothPattern({clothPiece("Front", 70, 60, 2)});
    ClothMarker marker;
    marker.width = 300;
    const auto add = [&marker](double x, double y) {
        LaidCopy copy;
        copy.placement.offset = {x, y};
        marker.copies.push_back(copy);
    };
    add(0, 0);
    add(70, 0);       // touches it
    add(500, 240.5);  // beyond the selvedge
    add(200, 100);
    add(210, 110);
    EXPECT_EQ(misplacedCopies(pattern, marker, {}), (std::vector<int>{2, 3, 4}));
}

TEST(ClothMarker, NothingToLayIsAnEmptyMarker) {
    const ClothMarker marker = laidOn(500, clothPattern({}));
    EXPECT_TRUE(marker.copies.empty() && marker.isOptimal);
    EXPECT_EQ(marker.length, 0);
}

TEST(ClothMarker, WhatIsKeptAndWiderThanTheClothStays) {
    Pattern pattern =
        clothPattern({clothPiece("back", 500, 300, 1), clothPiece("sleeve", 100, 100, 2)});
    const KeptCopy kept{{{1}, 0}, 0, {{100, 10}, 0, false}};
    Fabric fabric;
    fabric.width = 400;
    MarkerSettings settings;
    settings.gap = 20;
    const auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), "", fabric,
                                           settings, {kept}, Progress());
    ASSERT_TRUE(nester) << sentence(nester.error());
    EXPECT_EQ(nester->best().copies.size(), 2U);
    const KeptCopy upright{{{1}, 0}, 0, {{600, -50}, kPi / 2, false}};
    const auto wide = MarkerNester::make(std::make_shared<const Pattern>(pattern), "", fabric,
                                         settings, {upright}, Progress());
    ASSERT_TRUE(wide) << sentence(wide.error());
    EXPECT_TRUE(wide->best().isWhole);
}

TEST(ClothMarker, KeepsTheGapFromWhatIsKeptOnOthers) {
    Pattern pattern =
        clothPattern({clothPiece("back", 300, 500, 1), clothPiece("front", 200, 300, 2)});
    pattern.pieces[0].quantity = 2;
    const std::vector<KeptCopy> kept{{{{1}, 0}, 0, {{10, 10}, 0, false}},
                                     {{{1}, 1}, 0, {{20, 20}, 0, false}}};
    Fabric fabric;
    fabric.width = 530;
    MarkerSettings settings;
    settings.gap = 25;
    const auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), "", fabric,
                                           settings, kept, Progress());
    ASSERT_TRUE(nester) << sentence(nester.error());
    const auto front = std::ranges::find(nester->best().copies, 1, &LaidCopy::piece);
    ASSERT_NE(front, nester->best().copies.end());
    const Points2 line = laidOutline(pattern, *front);
    EXPECT_GE(line.col(0).minCoeff(), 160 + 25);
    for (const LaidCopy& copy : nester->best().copies) {
        if (copy.piece == 0) {
            const Points2 other = laidOutline(pattern, copy);
            for (Eigen::Index k = 0; k < line.rows(); ++k) {
                EXPECT_GE((other.rowwise() - line.row(k)).rowwise().norm().minCoeff(), 25 - 1e-3);
            }
        }
    }
}

TEST(ClothMarker, NamesOnlyWhatIsTooWideOfPiecesOfOneName) {
    const Pattern pattern =
        clothPattern({clothPiece("strip", 1620, 700, 1), clothPiece("strip", 700, 600, 2)});
    const ClothMarker marker = laidOn(1400, pattern);
    ASSERT_EQ(marker.copies.size(), 1U);
    EXPECT_EQ(marker.copies[0].piece, 1);
    EXPECT_EQ(marker.notes.size(), 1U);
}

TEST(ClothMarker, AnOutlineThatGoesRoundTwiceIsNamed) {
    Pattern pattern =
        clothPattern({clothPiece("loop", 100, 100, 1), clothPiece("Front", 70, 60, 2)});
    pattern.pieces[0].outline.resize(8, 2);
    pattern.pieces[0].outline << 0, 0, 90, 0, 90, 90, 0, 90, 0, 0, 90, 0, 90, 90, 0, 90;
    const ClothMarker marker = laidOn(1400, pattern);
    EXPECT_EQ(marker.copies.size(), 1U);
    EXPECT_EQ(marker.notes.size(), 1U);
}

TEST(ClothMarker, TurnsStayWithinTwoWholeOnes) {
    Pattern pattern = clothPattern({clothPiece("panel", 150, 180, 1)});
    pattern.pieces[0].quantity = 8;
    MarkerSettings settings;
    settings.turns = TurnRule::Free;
    for (const LaidCopy& copy : laidOn(500, pattern, settings, {}, 6).copies) {
        EXPECT_LE(std::abs(copy.placement.turn), 2 * kPi);
    }
}

TEST(PageOf, HoldsAllOfTheSheetsThatAreUsed) {
    MarkerSettings settings;
    settings.sheet = Eigen::Vector2d(900, 400);
    const ClothMarker marker = laidOn(0, clothPattern({clothPiece("p", 90, 80, 1)}), settings);
    EXPECT_EQ(pageOf(marker).width, 900);
    EXPECT_LT(marker.length, 900);
}

}  // namespace
}  // namespace toile
