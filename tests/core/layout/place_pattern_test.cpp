// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/place_pattern.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/pattern/piece_marks.h"

namespace toile {
namespace {

double signedArea(const Points2& outline) {
    double twice = 0;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const auto a = outline.row(i), b = outline.row((i + 1) % outline.rows());
        twice += a(0) * b(1) - a(1) * b(0);
    }
    return 0.5 * twice;
}

Pattern twoPieces() {
    Pattern pattern;
    pattern.pieces.resize(2);
    PatternPiece& one = pattern.pieces[0];
    one.name = one.id = "one";
    one.outline.resize(4, 2);
    one.outline << 10, 20, 110, 25, 105, 80, 12, 70;
    one.holes.resize(1);
    one.holes[0].resize(3, 2);
    one.holes[0] << 50, 40, 50, 50, 60, 45;
    one.seams.resize(1);
    one.seams[0].number = 1;
    one.seams[0].line = one.outline.topRows(2);
    PatternPiece& two = pattern.pieces[1];
    two.name = two.id = "two";
    two.outline = 0.5 * one.outline;
    return pattern;
}

TEST(PlaceOnSheet, WithoutPlacesIsTheRows) {
    Pattern pattern = twoPieces();
    const Sheet rows = layOutInRows(pattern);
    EXPECT_EQ(placeOnSheet(pattern, {}).offset, rows.offset);
    EXPECT_EQ(placeOnSheet(pattern, {{}, {}}).offset, rows.offset);
    EXPECT_EQ(pattern.pieces[0].outline, twoPieces().pieces[0].outline);
}

TEST(PlaceOnSheet, NotesHowOftenPiecesAreCut) {
    Pattern pattern = twoPieces();
    std::vector<PieceOnSheet> places(2);
    places[1].quantity = 5;
    places[1].mirroredPair = true;
    const Sheet sheet = placeOnSheet(pattern, places);
    EXPECT_EQ(pattern.pieces[0].quantity, 1);
    EXPECT_FALSE(pattern.pieces[0].mirroredPair);
    EXPECT_EQ(pattern.pieces[1].quantity, 5);
    EXPECT_TRUE(pattern.pieces[1].mirroredPair);
    EXPECT_EQ(sheet.offset, layOutInRows(pattern).offset);
    EXPECT_EQ(cuttingNote(1, false), "");
    EXPECT_EQ(cuttingNote(12, false), "cut 12");
    EXPECT_EQ(cuttingNote(1, true), "cut 1 pair");
    EXPECT_EQ(cuttingNote(3, true), "cut 3 pairs");
}

TEST(PlaceOnSheet, KeepsHowPiecesLieToEachOther) {
    const Pattern before = twoPieces();
    Pattern pattern = before;
    const Placement one{{300, -50}, 0.7, false}, two{{-80, 20}, -2.0, true};
    const Sheet sheet = placeOnSheet(pattern, {{one, 0.5}, {two, {}}});
    const auto placed = [&](std::size_t i) -> Points2 {
        return pattern.pieces[i].outline.rowwise() + sheet.offset[i].transpose();
    };
    const auto should = [&](std::size_t i, const Placement& placement) -> Points2 {
        const Points2 turned = before.pieces[i].outline * placement.linear().transpose();
        return turned.rowwise() + placement.offset.transpose();
    };
    const Points2 a = placed(0), b = placed(1).colwise().reverse();  // mirrored: the other way
    const Eigen::RowVector2d shift = a.row(0) - should(0, one).row(0);
    EXPECT_LT((a - (should(0, one).rowwise() + shift)).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((b - (should(1, two).rowwise() + shift)).cwiseAbs().maxCoeff(), 1e-10);
    const double low = std::min(a.minCoeff(), b.minCoeff());
    EXPECT_GE(low, -1e-9);
    EXPECT_NEAR(std::max(a.col(0).maxCoeff(), b.col(0).maxCoeff()), sheet.width, 1e-9);
    EXPECT_NEAR(std::max(a.col(1).maxCoeff(), b.col(1).maxCoeff()), sheet.height, 1e-9);
    EXPECT_NEAR(*pattern.pieces[0].grain, 1.2, 1e-12);
    EXPECT_FALSE(pattern.pieces[1].grain);
}

TEST(PlaceOnSheet, MirroredPiecesKeepTheirWindingAndSaySo) {
    Pattern pattern = twoPieces();
    const double area = signedArea(pattern.pieces[0].outline);
    const double hole = signedArea(pattern.pieces[0].holes[0]);
    placeOnSheet(pattern, {{Placement{{0, 0}, 1.0, true}, {}}, {}});
    EXPECT_TRUE(pattern.pieces[0].mirrored);
    EXPECT_FALSE(pattern.pieces[1].mirrored);
    EXPECT_NEAR(signedArea(pattern.pieces[0].outline), area, 1e-9);
    EXPECT_NEAR(signedArea(pattern.pieces[0].holes[0]), hole, 1e-9);
    // The seam still has the cloth on its left: it runs along the outline.
    const PatternPiece& piece = pattern.pieces[0];
    const Eigen::RowVector2d way = piece.seams[0].line.row(1) - piece.seams[0].line.row(0);
    bool found = false;
    for (Eigen::Index i = 0; i < piece.outline.rows(); ++i) {
        const Eigen::RowVector2d edge =
            piece.outline.row((i + 1) % piece.outline.rows()) - piece.outline.row(i);
        found = found || (edge - way).norm() < 1e-9;
    }
    EXPECT_TRUE(found);
}

TEST(PlaceOnSheet, PutsThoseWithoutAPlaceBesideTheOthers) {
    Pattern pattern = twoPieces();
    const Sheet sheet = placeOnSheet(pattern, {{Placement{{5, 5}, 0.3, false}, {}}, {}});
    const double right = pattern.pieces[0].outline.col(0).maxCoeff() + sheet.offset[0].x();
    EXPECT_GT(pattern.pieces[1].outline.col(0).minCoeff() + sheet.offset[1].x(), right);
    Pattern none;
    EXPECT_EQ(placeOnSheet(none, {}).width, 0);
}

}  // namespace
}  // namespace toile
