// SPDX-License-Identifier: GPL-3.0-or-later
// Stripes and plaids along seams.
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/marker/cloth_marker.h"
#include "tests/core/marker/marker_fixtures.h"

namespace toile {
namespace {

using test::clothPattern;
using test::laidOn;

/// A rectangle whose right side is sewn to the left side of the next.
PatternPiece stripedPiece(const std::string& name, std::uint64_t id, double width, double from) {
    PatternPiece piece = test::clothPiece(name, width, 400, id);
    piece.outline.resize(4, 2);
    piece.outline << 0, 0, width, from, width, 400, 0, 400;
    return piece;
}

SeamLine side(const std::string& name, bool isRight, Eigen::Vector2d from, Eigen::Vector2d to) {
    SeamLine seam;
    seam.name = name;
    seam.isRight = isRight;
    seam.line.resize(2, 2);
    seam.line << from.transpose(), to.transpose();
    return seam;
}

/// Front and back with a side seam, sewn from below to above.
Pattern sidesOf(double lower) {
    Pattern pattern =
        clothPattern({stripedPiece("front", 1, 230, lower), stripedPiece("back", 2, 170, 0)});
    pattern.pieces[0].seams = {side("side", false, {230, lower}, {230, 400})};
    pattern.pieces[1].seams = {side("side", true, {0, 400}, {0, lower})};
    return pattern;
}

TEST(Stripes, MeetAlongTheSeam) {
    const Pattern pattern = sidesOf(35);
    MarkerSettings settings;
    settings.repeat.warp = 80;
    settings.repeat.weft = 60;
    settings.repeat.origin = {7, 3};
    settings.garments = 3;
    settings.matched = {"side"};
    const ClothMarker marker = laidOn(900, pattern, settings, {}, 2);
    ASSERT_EQ(marker.copies.size(), 6U);
    EXPECT_TRUE(marker.notes.empty()) << marker.notes.front();
    for (const LaidCopy& copy : marker.copies) {
        const Eigen::Vector2d begins = copy.placement.applied(
            copy.piece == 0 ? Eigen::Vector2d(230, 35) : Eigen::Vector2d(0, 35));
        EXPECT_NEAR(std::remainder(begins.x() - 7, 80), 0, 1e-5);
        EXPECT_NEAR(std::remainder(begins.y() - 3, 60), 0, 1e-5);
    }
}

TEST(Stripes, NameSeamsThatAreNotKept) {
    Pattern pattern = sidesOf(35);
    // A second seam between the same pieces, whose ends are elsewhere: not both can be kept.
    pattern.pieces[0].seams.push_back(side("waist", false, {0, 400}, {0, 0}));
    pattern.pieces[1].seams.push_back(side("waist", true, {170, 10}, {170, 400}));
    MarkerSettings settings;
    settings.repeat.warp = 80;
    settings.matched = {"side", "waist", "hem"};
    const ClothMarker marker = laidOn(900, pattern, settings);
    ASSERT_EQ(marker.notes.size(), 2U);
    EXPECT_TRUE(marker.notes[0].ends_with(" hem")) << marker.notes[0];
    EXPECT_NE(marker.notes[1].find(" waist"), std::string::npos) << marker.notes[1];
    EXPECT_NE(marker.notes[1].find(" 10.0 mm off at its end"), std::string::npos);
}

TEST(Stripes, AreKeptInOneDirectionOnly) {
    const Pattern pattern = sidesOf(0);
    MarkerSettings settings;
    settings.repeat.warp = 80;
    settings.garments = 2;
    settings.matched = {"side"};
    for (const LaidCopy& copy : laidOn(900, pattern, settings).copies) {
        EXPECT_NEAR(directionOnSheet(copy.placement, kGrainUpwards), 0, 1e-12);
    }
}

TEST(Stripes, GoOnFromWhatIsKept) {
    const Pattern pattern = sidesOf(35);
    MarkerSettings settings;
    settings.repeat.warp = 80;
    settings.repeat.weft = 60;
    settings.matched = {"side"};
    const KeptCopy kept{{{1}, 0}, 0, {{523, 411}, -kPi / 2, false}};
    const ClothMarker marker = laidOn(900, pattern, settings, {kept}, 2);
    ASSERT_EQ(marker.copies.size(), 2U);
    EXPECT_TRUE(marker.notes.empty());
    std::vector<Eigen::Vector2d> begins(2);
    for (const LaidCopy& copy : marker.copies) {
        begins[static_cast<std::size_t>(copy.piece)] = copy.placement.applied(
            copy.piece == 0 ? Eigen::Vector2d(230, 35) : Eigen::Vector2d(0, 35));
    }
    EXPECT_NEAR(std::remainder(begins[0].x() - begins[1].x(), 80), 0, 1e-5);
    EXPECT_NEAR(std::remainder(begins[0].y() - begins[1].y(), 60), 0, 1e-5);
}

TEST(Stripes, GoOnFromTheFold) {
    Pattern pattern =
        clothPattern({test::clothPiece("front", 1, 1, 1), stripedPiece("back", 2, 170, 0)});
    PatternPiece& front = pattern.pieces[0];
    front.outline.resize(6, 2);
    front.outline << 0, 400, -130, 350, -130, 0, 0, 20, 130, 0, 130, 350;
    front.mirror.isSymmetric = true;
    MarkerSettings settings;
    settings.isFolded = true;
    settings.repeat.weft = 60;
    settings.repeat.origin = {7, 3};
    settings.matched = {"side"};
    pattern = patternOnCloth(pattern, settings);
    ASSERT_EQ(pattern.pieces[0].cutAs, CutAs::OnFold);
    const bool isLeft = pattern.pieces[0].outline.col(0).minCoeff() < -1;
    const double at = isLeft ? -130 : 130;
    pattern.pieces[0].seams = {side("side", false, {at, 0}, {at, 350})};
    pattern.pieces[1].seams = {side("side", true, {0, 350}, {0, 0})};
    const ClothMarker marker = laidOn(900, pattern, settings);
    ASSERT_EQ(marker.copies.size(), 2U);
    std::vector<double> begins(2);
    for (const LaidCopy& copy : marker.copies) {
        const Eigen::Vector2d point =
            copy.piece == 0 ? Eigen::Vector2d(at, 0) : Eigen::Vector2d(0, 0);
        begins[static_cast<std::size_t>(copy.piece)] = copy.placement.applied(point).y();
    }
    EXPECT_NEAR(std::remainder(begins[0] - begins[1], 60), 0, 1e-5);
}

}  // namespace
}  // namespace toile
