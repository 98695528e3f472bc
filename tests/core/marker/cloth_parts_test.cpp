// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets and hides.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/marker/cloth_marker.h"
#include "tests/core/marker/marker_fixtures.h"

namespace toile {
namespace {

using test::clothPattern;
using test::clothPiece;
using test::laidOn;

geometry::Polygon clothBox(double left, double bottom, double right, double top) {
    geometry::Polygon box(4, 2);
    box << left, bottom, right, bottom, right, top, left, top;
    return box;
}

TEST(ClothSheets, AreFilledOneAfterTheOther) {
    Pattern pattern = clothPattern({clothPiece("pocket", 140, 140, 1)});
    pattern.pieces[0].quantity = 9;
    MarkerSettings settings;
    settings.sheet = Eigen::Vector2d(305, 305);
    settings.border = 2;
    const ClothMarker marker = laidOn(0, pattern, settings);
    EXPECT_EQ(marker.copies.size(), 9U);
    EXPECT_FALSE(marker.isRoll);
    EXPECT_GE(marker.sheets, 2);
    EXPECT_LE(marker.sheets, 3);
    ASSERT_EQ(marker.parts.size(), static_cast<std::size_t>(marker.sheets));
    for (const LaidCopy& copy : marker.copies) {
        const Points2 line = laidOutline(pattern, copy);
        const geometry::Polygon& sheet = marker.parts[static_cast<std::size_t>(copy.sheet)].outline;
        EXPECT_GE(line.col(0).minCoeff(), sheet.col(0).minCoeff() + 2 - 1e-9);
        EXPECT_LE(line.col(0).maxCoeff(), sheet.col(0).maxCoeff() - 2 + 1e-9);
        EXPECT_LE(line.col(1).maxCoeff(), 303 + 1e-9);
    }
}

TEST(ClothSheets, NameWhatFitsOnNone) {
    const Pattern pattern =
        clothPattern({clothPiece("back", 200, 400, 1), clothPiece("pocket", 100, 90, 2)});
    MarkerSettings settings;
    settings.sheet = Eigen::Vector2d(305, 305);
    const ClothMarker marker = laidOn(0, pattern, settings);
    EXPECT_EQ(marker.copies.size(), 1U);
    EXPECT_FALSE(marker.isWhole);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_TRUE(marker.notes[0].starts_with("back ")) << marker.notes[0];
    EXPECT_NE(marker.notes[0].find("no sheet or hide"), std::string::npos);
}

std::shared_ptr<const Hide> testHide() {
    Hide hide;
    hide.name = "hide";
    hide.outline.resize(6, 2);
    hide.outline << 100, 0, 900, 0, 1000, 300, 900, 600, 100, 600, 0, 300;
    hide.zones.push_back({clothBox(450, 200, 550, 400), 0});
    hide.zones.push_back({clothBox(560, 50, 880, 550), 3});
    return std::make_shared<const Hide>(std::move(hide));
}

TEST(ClothHides, KeepHolesAndGrades) {
    Pattern pattern =
        clothPattern({clothPiece("panel", 150, 180, 1), clothPiece("lining", 120, 150, 2)});
    pattern.pieces[0].quantity = 3;
    pattern.pieces[1].quantity = 4;
    MarkerSettings settings;
    settings.hides = {testHide(), testHide()};
    settings.turns = TurnRule::Free;
    settings.grades["panel"] = 2;
    // Nothing lies in a hole, beyond the edge or, of what needs better, in the zone: all exact.
    const ClothMarker marker = laidOn(0, pattern, settings, {}, 2);
    EXPECT_EQ(marker.copies.size(), 7U);
    EXPECT_TRUE(marker.isWhole);
    EXPECT_EQ(marker.parts.front().zones.size(), 2U);
    EXPECT_GT(marker.use, 0);
    EXPECT_LT(marker.use, 1);
}

TEST(ClothHides, SayWhatHasNoRoomLeft) {
    Pattern pattern = clothPattern({clothPiece("panel", 390, 300, 1)});
    pattern.pieces[0].quantity = 5;
    MarkerSettings settings;
    settings.hides = {testHide()};
    const ClothMarker marker = laidOn(0, pattern, settings);
    EXPECT_GT(marker.copies.size(), 0U);
    EXPECT_LT(marker.copies.size(), 5U);
    EXPECT_FALSE(marker.isWhole);
    ASSERT_EQ(marker.notes.size(), 1U);
    EXPECT_NE(marker.notes[0].find("panel "), std::string::npos) << marker.notes[0];
}

TEST(ClothHides, NothingLiesBesideALowerRectangle) {
    Pattern pattern = clothPattern({clothPiece("panel", 380, 180, 1)});
    pattern.pieces[0].quantity = 4;
    MarkerSettings settings;
    for (const double height : {400.0, 900.0}) {
        Hide hide;
        hide.outline = clothBox(0, 0, 400, height);
        settings.hides.push_back(std::make_shared<const Hide>(hide));
    }
    EXPECT_EQ(laidOn(0, pattern, settings, {}, 2).copies.size(), 4U);  // none misplaced
}

TEST(ClothHides, WhatExceedsThemIsLeftOutOfWhatIsCutMostOften) {
    Pattern pattern =
        clothPattern({clothPiece("panel", 150, 180, 1), clothPiece("lining", 120, 150, 2)});
    pattern.pieces[0].quantity = 400;
    pattern.pieces[1].quantity = 2;
    MarkerSettings settings;
    settings.hides = {testHide()};
    const ClothMarker marker = laidOn(0, pattern, settings);
    EXPECT_FALSE(marker.isWhole);
    EXPECT_EQ(std::ranges::count(marker.copies, 1, &LaidCopy::piece), 2);
    EXPECT_GT(marker.copies.size(), 6U);
}

TEST(ClothSheets, TooManyCopiesAreRefusedAtOnce) {
    Pattern pattern = clothPattern({clothPiece("pocket", 100, 140, 1)});
    pattern.pieces[0].quantity = 1500;
    MarkerSettings settings;
    settings.sheet = Eigen::Vector2d(305, 305);
    settings.garments = 100'000'000;  // and no list is made for so many
    const auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), "", Fabric{},
                                           settings, {}, Progress());
    ASSERT_FALSE(nester);
    EXPECT_EQ(nester.error().code, ErrorCode::MalformedFile);
    EXPECT_EQ(nester.error().subject.name, "shirt");
}

}  // namespace
}  // namespace toile
