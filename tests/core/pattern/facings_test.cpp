// SPDX-License-Identifier: GPL-3.0-or-later
// Strips of pieces that are cut a second time.
#include "core/pattern/facings.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/layout/marker.h"
#include "core/pattern/half_pattern.h"
#include "core/toile/pipeline.h"
#include "tests/core/pattern/allowance_shapes.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

/// A piece 100 wide and 80 high with a half disk of radius 30 cut out of its upper edge, whose line
/// is number 7.
Pattern withNeckline() {
    std::vector<Eigen::RowVector2d> points{{0, 0}, {100, 0}, {100, 80}, {80, 80}};
    constexpr int kSteps = 60;
    for (int k = 1; k <= kSteps; ++k) {  // clockwise, seen from the middle of the disk
        const double angle = -std::numbers::pi * k / kSteps;
        points.emplace_back(50 + 30 * std::cos(angle), 80 + 30 * std::sin(angle));
    }
    points.emplace_back(0, 80);
    Pattern pattern;
    PatternPiece& piece = pattern.pieces.emplace_back();
    piece.name = "front";
    piece.outline.resize(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        piece.outline.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    const auto outline = geometry::Line::closed(piece.outline);
    const std::size_t corners[] = {0, 1, 2, 3, 3 + kSteps, 4 + kSteps};
    for (std::size_t k = 0; k < 6; ++k) {
        PatternSegment& segment = piece.segments.emplace_back();
        segment.from = outline.arc()[corners[k]];
        segment.to = k == 5 ? outline.length() : outline.arc()[corners[k + 1]];
        segment.seam = k == 3 ? 7 : 1;
        segment.allowance = 10;
        segment.place = {LineId{1}, static_cast<double>(k) / 6, static_cast<double>(k + 1) / 6};
    }
    piece.cuttingLine = piece.outline;  // allowances are asked for
    return pattern;
}

Facing alongNeckline(const Pattern& pattern, double width) {
    Facing facing;
    facing.edges.push_back(pattern.pieces[0].segments[3].place);
    facing.width = width;
    return facing;
}

TEST(Facings, FollowTheirEdgePointByPoint) {
    const Pattern pattern = withNeckline();
    const auto made = facingsOf(pattern, {alongNeckline(pattern, 15)});
    ASSERT_EQ(made.size(), 1U);
    const PatternPiece& strip = made[0].strip;
    ASSERT_GT(strip.outline.rows(), 61);
    EXPECT_EQ(Points2(strip.outline.topRows(61)),
              Points2(pattern.pieces[0].outline.middleRows(3, 61)));
    EXPECT_EQ(strip.segments.front().seam, 7);
    // Half a ring, to within the chords of both of its edges.
    EXPECT_NEAR(test::areaOf(strip.outline), std::numbers::pi / 2 * (45 * 45 - 30 * 30), 2);
    EXPECT_NEAR(strip.segments.back().to, geometry::Line::closed(strip.outline).length(), 1e-9);
}

TEST(Facings, HaveAnInnerEdgeFromEndToEnd) {
    const Pattern pattern = withNeckline();
    const PatternPiece strip = facingsOf(pattern, {alongNeckline(pattern, 15)})[0].strip;
    const Points2 edge = innerEdge(strip);
    ASSERT_GT(edge.rows(), 3);
    EXPECT_LT((edge.row(0) - strip.outline.row(60)).norm(), 1e-9);
    EXPECT_LT((edge.row(edge.rows() - 1) - strip.outline.row(0)).norm(), 1e-9);
}

/// Beside the edge the allowances of the piece, within it none.
TEST(Facings, HaveTheAllowancesOfTheirPieceButInside) {
    const Pattern pattern = withNeckline();
    const PatternPiece strip = facingsOf(pattern, {alongNeckline(pattern, 15)})[0].strip;
    ASSERT_EQ(strip.segments.size(), 4U);
    EXPECT_EQ(strip.segments[1].allowance, 10);
    EXPECT_EQ(strip.segments[2].allowance, 0);
    EXPECT_EQ(strip.segments[3].allowance, 10);
    // Two strips on the shoulders, 15 wide and 10 high, and what lies within the neckline.
    EXPECT_GT(test::areaOf(strip.cuttingLine), test::areaOf(strip.outline) + 2 * 15 * 10 - 1);
}

TEST(Facings, AreNoWiderThanTheirPiece) {
    const Pattern pattern = withNeckline();
    const PatternPiece strip = facingsOf(pattern, {alongNeckline(pattern, 500)})[0].strip;
    ASSERT_GT(strip.outline.rows(), 0);
    EXPECT_LE(test::areaOf(strip.outline), test::areaOf(pattern.pieces[0].outline) + 1e-3);
}

TEST(Facings, OfEdgesThatDoNotMeetAreTwo) {
    const Pattern pattern = withNeckline();
    Facing facing = alongNeckline(pattern, 15);
    facing.edges.push_back(pattern.pieces[0].segments[0].place);
    EXPECT_EQ(facingsOf(pattern, {facing}).size(), 2U);
    facing.edges.push_back(pattern.pieces[0].segments[5].place);  // beside the lower edge
    EXPECT_EQ(facingsOf(pattern, {facing}).size(), 2U);
}

/// One that has no room is there without an outline, to be named.
TEST(Facings, HaveNoStripRoundAWholeOutlineOrNearlySo) {
    const Pattern pattern = withNeckline();
    Facing facing;
    facing.width = 15;
    facing.edges.push_back({LineId{1}, 0, 1});
    auto made = facingsOf(pattern, {facing});
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].strip.outline.rows(), 0);
    facing.edges.front().to = 5.0 / 6;  // 80 mm are between the ends, which would meet
    facing.width = 50;
    made = facingsOf(pattern, {facing});
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].strip.outline.rows(), 0);
}

TEST(Facings, StayWhereSegmentsBecomeOne) {
    Pattern pattern = withNeckline();
    Facing facing;
    for (const std::size_t k : {2U, 3U, 4U}) {
        facing.edges.push_back(pattern.pieces[0].segments[k].place);
    }
    EXPECT_TRUE(isFaced({LineId{1}, 2.0 / 6, 5.0 / 6}, facing));
    EXPECT_FALSE(isFaced({LineId{1}, 5.0 / 6, 1}, facing));
}

TEST(Facings, AreNoneOfWhatIsGone) {
    const Pattern pattern = withNeckline();
    Facing facing;
    facing.edges.push_back({LineId{2}, 0, 1});
    EXPECT_TRUE(facingsOf(pattern, {facing}).empty());
}

TEST(Facings, AreCutAsTheirPieceIs) {
    Pattern pattern = withNeckline();
    pattern.facings = facingsOf(pattern, {alongNeckline(pattern, 15)});
    pattern.pieces[0].quantity = 2;
    pattern.pieces[0].grain = 1;
    const LaidOutPattern laid = cutAndPlace(pattern);
    ASSERT_EQ(laid.pattern.pieces.size(), 2U);
    EXPECT_EQ(laid.pattern.pieces[1].quantity, 2);
    EXPECT_EQ(laid.pattern.pieces[1].grain, 1);
    EXPECT_EQ(laid.pattern.pieces[1].number, 2);
    EXPECT_EQ(laid.marker.copies.size(), 2U);
    EXPECT_EQ(laid.whole.copies.size(), 1U);  // a UV map has the garment only
}

TEST(Facings, OfAPairAreCutAsOftenAsThat) {
    Pattern pattern = withNeckline();
    pattern.pieces.push_back(pattern.pieces[0]);
    pattern.pieces[0].mirror = {.counterpart = 1, .leads = true};
    pattern.pieces[1].mirror = {.counterpart = 0};
    pattern.pieces[0].byHalf = pattern.pieces[0].mirroredPair = true;
    pattern.pieces[0].quantity = 2;
    pattern.facings = facingsOf(pattern, {alongNeckline(pattern, 15)});
    ASSERT_EQ(pattern.facings.size(), 2U);
    const Pattern cut = asCut(pattern);
    ASSERT_EQ(cut.pieces.size(), 4U);
    for (const std::size_t k : {2U, 3U}) {
        EXPECT_EQ(cut.pieces[k].quantity, 2);
        EXPECT_FALSE(cut.pieces[k].mirroredPair);
    }
}

/// On a garment: the seam that a facing is sewn to is as long on both, and a seam's allowance does.
TEST(Facings, OfAGarmentFitTheirEdges) {
    const Garment garment = test::garmentOf("samples/tshirt.obj");
    LineSettings lines = withPattern({});
    Progress progress;
    const PieceResults results = flattenGarment(garment, {Method::Curvature}, progress, 0, lines);
    const auto symmetry = symmetryOf(garment, lines);
    const Pattern before = makePattern(garment, results, lines, symmetry);
    int faced = 0;
    for (const PatternPiece& piece : before.pieces) {
        for (const PatternSegment& segment : piece.segments) {
            if (segment.kind == SeamKind::Free && segment.seam > 0 && piece.segments.size() > 1) {
                lines.facings.push_back({"facing", {segment.place}, 40});
                ++faced;
            }
        }
    }
    ASSERT_GT(faced, 2);
    const Pattern pattern = makePattern(garment, results, lines, symmetry);
    ASSERT_EQ(static_cast<int>(pattern.facings.size()), faced);
    for (const FacingPiece& facing : pattern.facings) {
        const PatternPiece& strip = facing.strip;
        ASSERT_GT(strip.outline.rows(), 0);
        const auto outline = geometry::Line::closed(strip.outline);
        const PatternSegment& sewn = strip.segments.front();
        EXPECT_NEAR(outline.lengthOf(sewn.from, sewn.to), sewn.length, 1e-6);
        EXPECT_EQ(sewn.allowance, lines.allowance->seam);
        EXPECT_GT(test::areaOf(strip.outline), 0);
    }
}

}  // namespace
}  // namespace toile
