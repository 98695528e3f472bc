// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/marker.h"

#include <algorithm>

#include <gtest/gtest.h>

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
    one.name = one.slug = "one";
    one.outline.resize(4, 2);
    one.outline << 10, 20, 110, 25, 105, 80, 12, 70;
    one.holes.resize(1);
    one.holes[0].resize(3, 2);
    one.holes[0] << 50, 40, 50, 50, 60, 45;
    one.seams.resize(1);
    one.seams[0].number = 1;
    one.seams[0].line = one.outline.topRows(2);
    PatternPiece& two = pattern.pieces[1];
    two.name = two.slug = "two";
    two.outline = 0.5 * one.outline;
    return pattern;
}

using Placements = std::vector<std::optional<Placement>>;

/// The outline of a copy as it lies.
Points2 lies(const Pattern& pattern, const PlacedCopy& copy) {
    return turnedLine(pattern.pieces[static_cast<std::size_t>(copy.piece)].outline, copy.placement)
               .rowwise() +
           copy.placement.offset.transpose();
}

TEST(Marker, WithoutPlacesIsTheRows) {
    const Pattern pattern = twoPieces();
    const Rows rows = layOutInRows(pattern);
    for (const Placements& none : {Placements{}, Placements{{}, {}}}) {
        const Marker marker = placeCopies(pattern, none);
        ASSERT_EQ(marker.copies.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(marker.copies[i].placement, Placement{rows.offset[i]});
        }
        EXPECT_EQ(marker.width, rows.width);
        EXPECT_EQ(marker.height, rows.height);
    }
}

TEST(Marker, RowsAreNoWiderThanTheCloth) {
    Pattern pattern;
    for (int i = 0; i < 40; ++i) {
        PatternPiece piece = twoPieces().pieces[0];
        piece.outline *= 450 / (piece.outline.col(0).maxCoeff() - piece.outline.col(0).minCoeff());
        pattern.pieces.push_back(std::move(piece));
    }
    EXPECT_LE(placeCopies(pattern).width, kUsualClothWidth);  // of a fabric that nobody has stated
    const LaidOutPattern laid = cutAndPlace(pattern, {}, {"unstated", {}, {}, {}, 950});
    EXPECT_LE(laid.marker.width, 950);
    EXPECT_GT(laid.marker.width, 900);
    EXPECT_LE(laid.whole.width, 950);
}

TEST(Marker, LeavesOutWhatIsNotFlat) {
    Pattern pattern = twoPieces();
    pattern.pieces.insert(pattern.pieces.begin(), PatternPiece{});
    const Marker marker = placeCopies(pattern);
    ASSERT_EQ(marker.copies.size(), 2U);
    EXPECT_EQ(marker.copies[0].piece, 1);
    const Marker alone = placeCopies(twoPieces());
    EXPECT_EQ(marker.copies[1].placement, alone.copies[1].placement);
    EXPECT_EQ(marker.width, alone.width);
    EXPECT_EQ(placeCopies(Pattern{}).width, 0);
}

TEST(Marker, KeepsHowPiecesLieToEachOther) {
    const Pattern pattern = twoPieces();
    const Placement one{{300, -50}, 0.7, false}, two{{-80, 20}, -2.0, true};
    const Marker marker = placeCopies(pattern, {one, two});
    const auto should = [&](std::size_t i, const Placement& placement) -> Points2 {
        const Points2 turned = pattern.pieces[i].outline * placement.linear().transpose();
        return turned.rowwise() + placement.offset.transpose();
    };
    const Points2 a = lies(pattern, marker.copies[0]);
    const Points2 b = lies(pattern, marker.copies[1]).colwise().reverse();  // mirrored
    const Eigen::RowVector2d shift = a.row(0) - should(0, one).row(0);
    EXPECT_LT((a - (should(0, one).rowwise() + shift)).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((b - (should(1, two).rowwise() + shift)).cwiseAbs().maxCoeff(), 1e-10);
    const double low = std::min(a.minCoeff(), b.minCoeff());
    EXPECT_GE(low, -1e-9);
    EXPECT_NEAR(std::max(a.col(0).maxCoeff(), b.col(0).maxCoeff()), marker.width, 1e-9);
    EXPECT_NEAR(std::max(a.col(1).maxCoeff(), b.col(1).maxCoeff()), marker.height, 1e-9);
    EXPECT_EQ(marker.copies[1].placement.turn, two.turn);
    EXPECT_TRUE(marker.copies[1].placement.mirrored);
}

TEST(Marker, MirroredLinesKeepTheClothOnTheirLeft) {
    const PatternPiece piece = twoPieces().pieces[0];
    const Placement mirrored{{0, 0}, 1.0, true};
    const Points2 outline = turnedLine(piece.outline, mirrored);
    EXPECT_NEAR(signedArea(outline), signedArea(piece.outline), 1e-9);
    EXPECT_NEAR(signedArea(turnedLine(piece.holes[0], mirrored)), signedArea(piece.holes[0]), 1e-9);
    // A seam still runs along the outline.
    const Points2 seam = turnedLine(piece.seams[0].line, mirrored);
    const Eigen::RowVector2d way = seam.row(1) - seam.row(0);
    bool found = false;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Eigen::RowVector2d edge = outline.row((i + 1) % outline.rows()) - outline.row(i);
        found = found || (edge - way).norm() < 1e-9;
    }
    EXPECT_TRUE(found);
    // What is not turned keeps every digit.
    EXPECT_EQ(turnedLine(piece.outline, {{5, 5}, 0, false}), piece.outline);
}

TEST(Marker, PutsThoseWithoutAPlaceBesideTheOthers) {
    const Pattern pattern = twoPieces();
    const Marker marker = placeCopies(pattern, {Placement{{5, 5}, 0.3, false}, {}});
    EXPECT_GT(lies(pattern, marker.copies[1]).col(0).minCoeff(),
              lies(pattern, marker.copies[0]).col(0).maxCoeff());
}

}  // namespace
}  // namespace toile
