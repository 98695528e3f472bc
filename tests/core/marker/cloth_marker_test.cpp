// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_marker.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace toile {
namespace {

/// As wide across the cloth as high, but for a corner that tells turned and mirrored apart.
PatternPiece clothPiece(const std::string& name, double width, double height,
                        std::uint64_t id = 0) {
    PatternPiece piece;
    piece.name = piece.slug = name;
    piece.id = {id};
    piece.outline.resize(5, 2);
    piece.outline << 0, 0, width, 0, width, height / 2, width / 2, height, 0, height;
    return piece;
}

Pattern clothPattern(std::vector<PatternPiece> pieces) {
    Pattern pattern;
    pattern.name = "shirt";
    pattern.pieces = std::move(pieces);
    return pattern;
}

Fabric clothOf(double width) {
    Fabric fabric = fabricPresets().front();
    fabric.width = width;
    return fabric;
}

ClothMarker laidOn(double width, const Pattern& pattern, const MarkerSettings& settings = {},
                   const std::vector<KeptCopy>& kept = {}, int rounds = 1,
                   const std::string& material = {}) {
    auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), material,
                                     clothOf(width), settings, kept, Progress());
    EXPECT_TRUE(nester) << sentence(nester.error());
    for (int k = 0; nester && k < rounds; ++k) {
        nester->step(Progress());
    }
    if (!nester) {
        return {};
    }
    EXPECT_TRUE(misplacedCopies(pattern, nester->best(), settings).empty());
    return nester->best();
}

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
              "Back is not laid: it is 1620 mm across, the cloth 1400 mm; splice it at 1390 mm");
}

TEST(ClothMarker, AnOutlineThatCrossesItselfIsNamed) {
    Pattern pattern =
        clothPattern({clothPiece("bow", 100, 100, 1), clothPiece("Front", 70, 60, 2)});
    pattern.pieces[0].outline.resize(4, 2);
    pattern.pieces[0].outline << 0, 0, 100, 100, 100, 0, 0, 50;
    const ClothMarker marker = laidOn(1400, pattern);
    EXPECT_EQ(marker.copies.size(), 1U);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_EQ(marker.notes[0], "bow is not laid: its outline crosses itself");
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
    EXPECT_EQ(marker.notes[0],
              "pocket is cut through both layers of the folded cloth: 1 more than are needed");
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
    add(70, 0);  // touches it
    add(500, 240.5);
    add(200, 100);
    add(210, 110);
    EXPECT_EQ(misplacedCopies(pattern, marker, {}), (std::vector<int>{2, 3, 4}));
}

TEST(ClothMarker, NothingToLayIsAnEmptyMarker) {
    const ClothMarker marker = laidOn(500, clothPattern({}));
    EXPECT_TRUE(marker.copies.empty() && marker.isOptimal);
    EXPECT_EQ(marker.length, 0);
}

}  // namespace
}  // namespace toile
