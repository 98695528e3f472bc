// SPDX-License-Identifier: GPL-3.0-or-later
// Darts: where they are found, their caps, and the line that allowances are laid around. Longer
// than a file mostly is: every special case of a cap is closed and folded here by the same few
// helpers.
#include "core/pattern/darts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "core/assemble/seams_file.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/piece_allowance.h"
#include "core/quality/outline_crossings.h"
#include "core/toile/pipeline.h"
#include "tests/core/pattern/allowance_shapes.h"
#include "tests/core/pattern/dart_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using test::ClosedDart;
using test::Corners;
using test::DartRows;

constexpr double kExactly = 1e-9;

Vector2d reflectedIn(const Chord& line, const Vector2d& point) {
    const Vector2d along = (line.to - line.from).normalized(), rest = point - line.from;
    return line.from + 2 * along.dot(rest) * along - rest;
}

PieceDart onlyDart(PatternPiece piece, const std::map<SeamId, DartLay>& lays = {}) {
    for (const auto& [seam, lay] : lays) {
        piece.statedDarts[seam].lay = lay;
    }
    const std::vector<PieceDart> darts = findDarts(piece);
    EXPECT_EQ(darts.size(), 1U);
    return darts.empty() ? PieceDart{} : darts.front();
}

/// The sewn dart's edge: its cap, folded on the fold line and laid over the leg.
Points2 foldedCap(const PieceDart& dart) {
    const bool overFirst = dart.lay == DartLay::First;
    const Chord leg{dart.tip, overFirst ? dart.mouth.from : dart.mouth.to};
    Points2 folded = dart.cap;
    for (Eigen::Index k = 0; k < folded.rows(); ++k) {
        const bool isBeyondFold = overFirst ? k > folded.rows() / 2 : k < folded.rows() / 2;
        const Vector2d p = folded.row(k);
        folded.row(k) = reflectedIn(leg, isBeyondFold ? reflectedIn(dart.fold, p) : p);
    }
    return folded;
}

void expectOnSeamLine(const PatternPiece& piece, const PieceDart& dart, double tolerance) {
    const Points2 folded = foldedCap(dart);
    ASSERT_GT(folded.rows(), 2);
    for (Eigen::Index k = 0; k + 1 < folded.rows(); ++k) {
        for (const double share : {0.0, 0.37, 1.0}) {
            const Eigen::RowVector2d at =
                folded.row(k) + share * (folded.row(k + 1) - folded.row(k));
            EXPECT_LT(test::distanceTo(at, piece.outline), tolerance) << k;
        }
    }
}

bool isSimple(const Points2& line) {
    std::vector<int> all(static_cast<std::size_t>(line.rows()));
    std::iota(all.begin(), all.end(), 0);
    return outlineIsSimple(line, all);
}

/// What is true of darts with legs that do not cross.
void expectSoundCloth(const PieceDart& dart, const Points2& cloth) {
    if (dart.intake > 1e-6) {
        EXPECT_TRUE(isSimple(cloth));
        EXPECT_LT(test::outside(dart.drill.transpose(), cloth), 0);
    }
}

/// The cap and the legs, back.
Points2 clothOf(const PatternPiece& piece, const PieceDart& dart) {
    const Points2 legs = geometry::Line::closed(piece.outline).part(dart.from, dart.to);
    Points2 cloth(dart.cap.rows() + legs.rows() - 2, 2);
    cloth << dart.cap, legs.middleRows(1, legs.rows() - 2).colwise().reverse();
    return cloth;
}

/// What is true of any darts whatever and of the line around them.
void expectSoundLine(const PatternPiece& piece, const std::vector<PieceDart>& darts) {
    double area = test::areaOf(piece.outline);
    for (const PieceDart& dart : darts) {
        EXPECT_TRUE(dart.cap.allFinite() && dart.drill.allFinite() && dart.fold.to.allFinite());
        EXPECT_TRUE(std::isfinite(dart.angle) && std::isfinite(dart.intake));
        if (dart.cap.rows() == 0) {
            EXPECT_EQ(dart.fold.to, dart.tip);
            EXPECT_EQ(dart.drill, dart.tip);
            continue;
        }
        EXPECT_LT((dart.cap.row(0).transpose() - dart.mouth.from).norm(), kExactly);
        EXPECT_LT((dart.cap.bottomRows<1>().transpose() - dart.mouth.to).norm(), kExactly);
        area += test::areaOf(clothOf(piece, dart));
    }
    const CappedOutline capped = cappedOutline(piece, darts);
    EXPECT_TRUE(isSimple(capped.line));
    EXPECT_NEAR(test::areaOf(capped.line), area, 1e-9 * area);
    ASSERT_FALSE(capped.stretches.empty());
    for (std::size_t k = 0; k < capped.stretches.size(); ++k) {
        EXPECT_TRUE(k == 0 || capped.stretches[k - 1].first < capped.stretches[k].first);
        EXPECT_LT(capped.stretches[k].first, capped.line.rows());
    }
}

void expectSound(const PatternPiece& piece, const std::vector<PieceDart>& darts) {
    expectSoundLine(piece, darts);
    for (const PieceDart& dart : darts) {
        if (dart.cap.rows() > 0) {
            expectSoundCloth(dart, clothOf(piece, dart));
        }
    }
}

constexpr double kAngle = 0.35;

/// The lower edge is straight, and the dart square to it.
const ClosedDart kSquare{{{-300, 0}}, {0, 0}, {0, 120}, {{300, 0}}, kAngle};
const ClosedDart kSlanted{{{-280, 20}, {-100, 5}},
                          {-80, 3.3333333333333335},
                          {0, 150},
                          {{120, -13.333333333333334}, {260, -25}},
                          kAngle};

/// In a lower edge that is part of a circle, slanting.
ClosedDart curvedHem() {
    ClosedDart dart{{}, {-60, 0}, {-30, 140}, {}, kAngle};
    const auto at = [](double x) { return Vector2d(x, 400 - std::sqrt(400 * 400 - x * x)); };
    for (int x = -290; x <= 290; x += 5) {
        if (x != -60) {
            (x < -60 ? dart.left : dart.right).push_back(at(x));
        }
    }
    dart.mouth = at(-60);
    return dart;
}

TEST(Darts, HaveIntakeAngleAndLegsOfEqualLength) {
    const PatternPiece piece = kSquare.opened();
    const PieceDart dart = onlyDart(piece);
    EXPECT_EQ(dart.seam, 1);
    EXPECT_NEAR(dart.angle, kAngle, kExactly);
    EXPECT_NEAR(dart.intake, 2 * 120 * std::sin(kAngle / 2), kExactly);
    EXPECT_NEAR(dart.leg, 120, kExactly);
    EXPECT_NEAR(dart.to - dart.from, 240, kExactly);
    EXPECT_LT((dart.tip - kSquare.tip).norm(), kExactly);
    EXPECT_LT((dart.mouth.to - kSquare.mouth).norm(), kExactly);
    expectSound(piece, {dart});
}

TEST(Darts, CapOfASquareDartInAStraightEdgeIsAPeak) {
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        const PatternPiece piece = kSquare.opened();
        const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
        EXPECT_EQ(dart.lay, lay);
        ASSERT_EQ(dart.cap.rows(), 3);
        const Vector2d fold(-std::sin(kAngle / 2), -std::cos(kAngle / 2));
        const Vector2d peak = kSquare.tip + 120 / std::cos(kAngle / 2) * fold;
        EXPECT_LT((dart.cap.row(1).transpose() - peak).norm(), kExactly);
        EXPECT_LT((dart.fold.to - peak).norm(), kExactly);
        EXPECT_LT((dart.drill - (kSquare.tip + 12 * fold)).norm(), kExactly);
        expectOnSeamLine(piece, dart, kExactly);
        expectSound(piece, {dart});
    }
}

TEST(Darts, FoldedCapsOfSlantingDartsLieOnTheSeamLine) {
    for (const ClosedDart& shape : {kSlanted, curvedHem()}) {
        for (const DartLay lay : {DartLay::First, DartLay::Second}) {
            const PatternPiece piece = shape.opened();
            const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
            expectOnSeamLine(piece, dart, kExactly);
            expectSound(piece, {dart});
        }
    }
}

TEST(Darts, CapsOfCurvedLegsLieOnTheSeamLineNearTheMouth) {
    ClosedDart shape = kSquare;
    for (int k = 1; k < 24; ++k) {
        const double y = 5 * k;
        shape.leg.emplace_back(y < 12 ? 0 : 6e-4 * (y - 12) * (120 - y), y);
    }
    const PatternPiece piece = shape.opened();
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
        EXPECT_GT(dart.leg, 120);
        expectSound(piece, {dart});
        expectOnSeamLine(piece, dart, kExactly);  // chord and mouth are square to the edge
    }
}

TEST(Darts, MouthsOfUnequalDistanceFromTheTipGetCapsToo) {
    // One leg straight, the other bent and as long.
    const double bend = 20, half = 60;
    const double across = 2 * std::sqrt(half * half - bend * bend);
    const Vector2d way = Vector2d(30, -120).normalized();
    const Corners outline{{-300, 0},
                          Vector2d(0, 120) + 120 * Vector2d(-30, -120).normalized(),
                          {0, 120},
                          Vector2d(0, 120) + across / 2 * way + bend * Vector2d(-way.y(), way.x()),
                          Vector2d(0, 120) + across * way,
                          {300, 0},
                          {300, 300},
                          {-300, 300}};
    const PatternPiece piece = test::pieceWithDarts(outline, {{1, 2, 4}}, {0, 5, 6, 7});
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
        EXPECT_NEAR(dart.leg, dart.to - dart.from - dart.leg, kExactly);
        EXPECT_EQ(dart.cap.rows(), 3);
        expectSound(piece, {dart});
    }
}

void expectSame(const PieceDart& dart, const PieceDart& other, double angle,
                const Eigen::RowVector2d& by) {
    const Eigen::Rotation2Dd turn(angle);
    ASSERT_EQ(dart.cap.rows(), other.cap.rows());
    for (Eigen::Index k = 0; k < dart.cap.rows(); ++k) {
        const Vector2d p = turn * dart.cap.row(k).transpose() + by.transpose();
        EXPECT_LT((p - other.cap.row(k).transpose()).norm(), kExactly);
    }
    EXPECT_EQ(dart.lay, other.lay);
    EXPECT_NEAR(dart.angle, other.angle, kExactly);
    EXPECT_NEAR(dart.intake, other.intake, kExactly);
    EXPECT_LT((turn * dart.drill + by.transpose() - other.drill).norm(), kExactly);
}

TEST(Darts, AreTheSameHoweverThePieceLiesOrBegins) {
    for (const ClosedDart& shape : {kSquare, kSlanted, curvedHem()}) {
        const PatternPiece piece = shape.opened();
        const PieceDart dart = onlyDart(piece);
        expectSame(dart, onlyDart(test::moved(piece, 2.1, {90, -40})), 2.1, {90, -40});
        for (int row = 1; row < piece.outline.rows(); ++row) {
            const PatternPiece begun = test::begunAt(piece, row);
            const PieceDart again = onlyDart(begun);
            expectSame(dart, again, 0, {0, 0});
            EXPECT_LT(again.from, geometry::Line::closed(begun.outline).length());
            const CappedOutline capped = cappedOutline(begun, {again});
            EXPECT_NEAR(test::areaOf(capped.line), test::areaOf(cappedOutline(piece, {dart}).line),
                        1e-6);
            EXPECT_EQ(capped.stretches.size(), 5U);
        }
    }
}

TEST(Darts, MirrorImagesHaveMirroredDarts) {
    for (const ClosedDart& shape : {kSlanted, curvedHem()}) {
        const PatternPiece piece = shape.opened();
        const PieceDart dart = onlyDart(piece), image = onlyDart(test::mirrored(piece));
        EXPECT_NE(dart.lay, image.lay);
        EXPECT_NEAR(dart.angle, image.angle, kExactly);
        Points2 cap = image.cap.colwise().reverse();
        cap.col(0) *= -1;
        ASSERT_EQ(cap.rows(), dart.cap.rows());
        EXPECT_LT((cap - dart.cap).cwiseAbs().maxCoeff(), kExactly);
    }
}

TEST(Darts, AreLaidTowardsTheMiddleOrDownwards) {
    for (const double x : {-90.0, 90.0}) {
        ClosedDart shape = kSquare;
        shape.mouth.x() = shape.tip.x() = x;
        const PatternPiece piece = shape.opened();
        EXPECT_EQ(onlyDart(piece).lay, x < 0 ? DartLay::Second : DartLay::First);
        // With the warp across, the edge stands upright and the dart is level.
        PatternPiece turned = piece;
        turned.grain = 0;
        EXPECT_EQ(onlyDart(turned).lay, DartLay::First);
        turned.grain = std::numbers::pi;
        EXPECT_EQ(onlyDart(turned).lay, DartLay::Second);
    }
}

TEST(Darts, SplitByTurnPointsAreStillOne) {
    ClosedDart shape = curvedHem();
    shape.leg = {{-52.5, 38}, {-45, 70}, {-37, 105}};
    const PatternPiece whole = shape.opened();
    PatternPiece split = whole;
    split.segments.clear();
    for (const PatternSegment& segment : whole.segments) {
        const double middle = 0.5 * (segment.from + segment.to);
        split.segments.push_back(segment);
        split.segments.back().to = middle;
        split.segments.push_back(segment);
        split.segments.back().from = middle;
        split.segments.back().isCorner = false;
    }
    const PieceDart dart = onlyDart(split);
    expectSame(onlyDart(whole), dart, 0, {0, 0});
    expectSound(split, {dart});
}

/// A straight edge from x = 0 with darts of 60 mm, all legs slanting by as much.
PatternPiece row(const std::vector<double>& mouths, double intake) {
    Corners outline{{0, 0}};
    std::vector<DartRows> rows;
    for (const double x : mouths) {
        if (outline.back().x() != x) {
            outline.emplace_back(x, 0);
        }
        const int k = static_cast<int>(outline.size()) - 1;
        rows.push_back({k, k + 1, k + 2});
        outline.emplace_back(x + intake / 2, 60);
        outline.emplace_back(x + intake, 0);
    }
    outline.insert(outline.end(), {{500, 0}, {500, 200}, {0, 200}});
    const int n = static_cast<int>(outline.size());
    return test::pieceWithDarts(outline, rows, {0, n - 3, n - 2, n - 1});
}

TEST(Darts, SideBySideHaveCapsThatDoNotMeet) {
    for (const double apart : {0.0, 1e-7, 0.5, 4.0, 40.0}) {
        for (const double intake : {2.0, 20.0, 60.0}) {
            SCOPED_TRACE(std::to_string(apart) + ", " + std::to_string(intake));
            const PatternPiece piece =
                row({30, 30 + intake + apart, 30 + 2 * (intake + apart)}, intake);
            const std::vector<PieceDart> darts = findDarts(piece);
            ASSERT_EQ(darts.size(), 3U);
            EXPECT_LT(darts[0].from, darts[1].from);
            expectSound(piece, darts);
            for (const PieceDart& dart : darts) {
                EXPECT_GE(dart.cap.rows(), 2);
                EXPECT_NEAR(dart.intake, intake, kExactly);
            }
        }
    }
}

TEST(Darts, NearACornerAreCappedAlongTheirEdgeProlonged) {
    const PatternPiece piece = row({2}, 30);  // the folded half is 15 mm wide
    const PieceDart far = onlyDart(row({90}, 30), {{SeamId{1}, DartLay::First}});
    const PieceDart dart = onlyDart(piece, {{SeamId{1}, DartLay::First}});
    ASSERT_EQ(dart.cap.rows(), far.cap.rows() + 2);
    EXPECT_LT((dart.fold.to - far.fold.to - Vector2d(-88, 0)).norm(), kExactly);
    expectSound(piece, {dart});
}

TEST(Darts, ThatDoNotOpenHaveACapWithoutArea) {
    const ClosedDart shape{{{-300, 0}}, {-20, 0}, {0, 120}, {{300, 0}}, 0};
    const PatternPiece piece = shape.opened();
    const PieceDart dart = onlyDart(piece);
    EXPECT_EQ(dart.intake, 0);
    EXPECT_NEAR(dart.angle, 0, kExactly);
    EXPECT_EQ(dart.cap.rows(), 2);
    EXPECT_LT((dart.fold.to - shape.mouth).norm(), kExactly);
    EXPECT_TRUE(dart.drill.allFinite());
    const CappedOutline capped = cappedOutline(piece, {dart});
    EXPECT_NEAR(test::areaOf(capped.line), 600 * 300, 1e-6);
    Points2 rectangle(4, 2);
    rectangle << -300, 0, 300, 0, 300, 300, -300, 300;
    EXPECT_LT(test::apart(capped.line, rectangle), kExactly);
}

TEST(Darts, WhoseLegsCrossHaveNoCap) {
    ClosedDart shape = kSquare;
    shape.angle = -0.1;
    const PatternPiece piece = shape.opened();
    const PieceDart dart = onlyDart(piece);
    EXPECT_NEAR(dart.angle, -0.1, kExactly);
    EXPECT_EQ(dart.cap.rows(), 0);
    EXPECT_EQ(dart.fold.to, dart.tip);
    EXPECT_EQ(dart.drill, dart.tip);
    EXPECT_EQ(dartMarks(dart).fold.rows(), 0);
    EXPECT_EQ(dartMarks(dart).drill.rows(), 0);
    const CappedOutline capped = cappedOutline(piece, {dart});
    EXPECT_EQ(capped.line, piece.outline);
    EXPECT_EQ(capped.stretches.size(), piece.segments.size());
}

/// In the lower edge, square to it, of any angle.
PatternPiece wideDart(double angle) {
    const double x = 60 * std::sin(angle / 2), y = 100 - 60 * std::cos(angle / 2);
    const Corners outline{{-300, y}, {-x, y}, {0, 100}, {x, y}, {300, y}, {300, 300}, {-300, 300}};
    return test::pieceWithDarts(outline, {{1, 2, 3}}, {0, 4, 5, 6});
}

TEST(Darts, ThatOpenAsWideAsACornerAreNone) {
    constexpr double kDegree = std::numbers::pi / 180;
    for (const double degrees : {30.0, 45.0, 59.9, 60.1, 90.0, 120.0, 179.0, 181.0, 240.0}) {
        SCOPED_TRACE(degrees);
        const PatternPiece piece = wideDart(degrees * kDegree);
        if (degrees > 60) {
            EXPECT_TRUE(findDarts(piece).empty());
            EXPECT_EQ(cappedOutline(piece, findDarts(piece)).line, piece.outline);
            continue;
        }
        const PieceDart dart = onlyDart(piece);
        EXPECT_NEAR(dart.angle, degrees * kDegree, kExactly);
        // The mirrored edge and the fold meet at pi / 2 - angle.
        const double fold = 60 * std::cos(dart.angle / 2) / std::cos(dart.angle);
        EXPECT_EQ(dart.cap.rows(), 3);
        EXPECT_NEAR((dart.fold.to - dart.tip).norm(), fold, kExactly);
        expectSound(piece, {dart});
    }
}

TEST(Darts, ThatOpenBySixtyDegreesAreNoneHoweverThatIsRounded) {
    const PatternPiece piece = wideDart(std::numbers::pi / 3);
    for (int step = 0; step < 90; ++step) {
        SCOPED_TRACE(step);
        const PatternPiece turned = test::moved(piece, 0.07 * step, {1000.0 / 7, 500.0 / 3});
        EXPECT_TRUE(findDarts(turned).empty());
        EXPECT_TRUE(findDarts(test::mirrored(turned)).empty());
    }
}

TEST(Darts, CapsThatWouldMeetTheOutlineAreStraight) {
    // A leg of the piece comes up to just below the mouth.
    const Corners outline{{-300, 0},  {-30, 0},    {0, 120},   {30, 0},    {100, 0},   {100, -20},
                          {-100, -4}, {-100, -60}, {300, -60}, {300, 300}, {-300, 300}};
    const PatternPiece piece =
        test::pieceWithDarts(outline, {{1, 2, 3}}, {0, 4, 5, 6, 7, 8, 9, 10});
    EXPECT_EQ(onlyDart(row({135}, 60)).cap.rows(), 3);
    const PieceDart dart = onlyDart(piece);
    EXPECT_EQ(dart.cap.rows(), 2);
    expectSound(piece, {dart});
}

TEST(Darts, OfAHalfPatternAreThoseOfTheWhole) {
    // Symmetric about x = 0, from its top to its bottom, with a slanting dart on either side.
    const Corners outline{{0, 300}, {-200, 300}, {-200, 0}, {-120, 5}, {-60, 140}, {-70, 10},
                          {0, 0},   {70, 10},    {60, 140}, {120, 5},  {200, 0},   {200, 300}};
    PatternPiece whole = test::pieceWithDarts(outline, {{3, 4, 5}, {7, 8, 9}}, {0, 1, 2, 10, 11});
    whole.mirror.isSymmetric = true;
    whole.byHalf = true;
    const PatternPiece half = asCut({"", {whole}}).pieces[0];
    ASSERT_EQ(half.cutAs, CutAs::OnFold);
    const std::vector<PieceDart> darts = findDarts(whole), ofHalf = findDarts(half);
    ASSERT_EQ(darts.size(), 2U);
    ASSERT_EQ(ofHalf.size(), 1U);
    expectSame(darts[0], ofHalf[0], 0, {0, 0});
    EXPECT_EQ(darts[0].lay, DartLay::Second);
    EXPECT_EQ(darts[1].lay, DartLay::First);
    expectSound(whole, darts);
    expectSound(half, ofHalf);
    EXPECT_NEAR(2 * test::areaOf(cappedOutline(half, ofHalf).line),
                test::areaOf(cappedOutline(whole, darts).line), 1e-6);
}

TEST(Darts, AreNotFoundWhereThereAreNone) {
    EXPECT_TRUE(findDarts({}).empty());
    PatternPiece piece = kSquare.opened();
    for (SeamLine& side : piece.seams) {
        side.kind = SeamKind::Fold;
    }
    EXPECT_TRUE(findDarts(piece).empty());
    piece = kSquare.opened();
    piece.seams.resize(1);  // the other side is not on this outline
    EXPECT_TRUE(findDarts(piece).empty());
    const CappedOutline capped = cappedOutline(piece, {});
    EXPECT_EQ(capped.line, piece.outline);
    EXPECT_EQ(capped.stretches.size(), piece.segments.size());
    piece.segments.clear();
    EXPECT_EQ(cappedOutline(piece, {}).stretches.size(), 1U);
    EXPECT_EQ(cappedOutline(piece, {}).stretches.front().segment, -1);
    EXPECT_EQ(cappedOutline({}, {}).line.rows(), 0);
}

/// Every stretch with its segment's width.
Points2 cutAround(const CappedOutline& capped, const std::vector<double>& widths) {
    std::vector<AllowanceStretch> stretches;
    for (const CappedStretch& stretch : capped.stretches) {
        stretches.push_back({stretch.first, widths[static_cast<std::size_t>(stretch.segment)]});
    }
    return cuttingLine(capped.line, stretches);
}

TEST(CappedOutlines, HaveAllowancesThatLieOnEachOtherWhenFolded) {
    // Segments: before the dart, its legs, after it, and the other three sides.
    constexpr double kWidth = 10;
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        const PatternPiece piece = kSquare.opened();
        const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
        const CappedOutline capped = cappedOutline(piece, {dart});
        ASSERT_EQ(capped.stretches.size(), 5U);
        const Points2 cut = cutAround(capped, std::vector<double>(7, kWidth));
        const Vector2d fold = (dart.fold.to - dart.tip).normalized();
        const Vector2d tip = dart.tip + (120 + kWidth) / std::cos(kAngle / 2) * fold;
        EXPECT_LT(test::distanceTo(tip.transpose(), cut), 1e-4);
        // On the leg prolonged the allowances of edge and cap meet.
        for (const Vector2d& mouth : {dart.mouth.from, dart.mouth.to}) {
            const Vector2d end = mouth + kWidth * (mouth - dart.tip).normalized();
            EXPECT_LT(test::distanceTo(end.transpose(), cut), 1e-4);
        }
    }
}

TEST(CappedOutlines, GiveACapToTheSegmentThatItIsLaidOver) {
    const PatternPiece piece = kSquare.opened();
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        const PieceDart dart = onlyDart(piece, {{SeamId{1}, lay}});
        const CappedOutline capped = cappedOutline(piece, {dart});
        // Which stretch each point of the cap begins an edge of.
        const Vector2d begin = lay == DartLay::First ? dart.mouth.to : dart.mouth.from;
        int found = 0;
        for (const CappedStretch& stretch : capped.stretches) {
            EXPECT_TRUE(stretch.segment != 1 && stretch.segment != 2);  // the legs
            if (stretch.segment == 3) {
                EXPECT_LT((capped.line.row(stretch.first).transpose() - begin).norm(), kExactly);
                ++found;
            }
        }
        EXPECT_EQ(found, 1);
        // Hence with the width before or after the dart.
        const Points2 cut = cutAround(capped, {5, 0, 0, 20, 0, 0, 0});
        const double wide = test::outside(dart.cap.row(1), cut);
        EXPECT_LT(wide, 0);
        EXPECT_NEAR(-wide, lay == DartLay::First ? 5 : 20, 1e-4);
    }
}

TEST(CappedOutlines, CoverEverySegmentButLegs) {
    const PatternPiece piece = row({30, 100, 250}, 20);
    const std::vector<PieceDart> darts = findDarts(piece);
    for (int start = 0; start < piece.outline.rows(); ++start) {
        const PatternPiece begun = test::begunAt(piece, start);
        const CappedOutline capped = cappedOutline(begun, findDarts(begun));
        std::vector<int> seen;
        for (const CappedStretch& stretch : capped.stretches) {
            seen.push_back(stretch.segment);
            const auto& segment = begun.segments[static_cast<std::size_t>(stretch.segment)];
            EXPECT_EQ(segment.kind, SeamKind::Seam);
        }
        std::ranges::sort(seen);
        EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
        EXPECT_EQ(seen.size(), 7U);
    }
    expectSound(piece, darts);
}

TEST(DartMarks, AreFoldDrillPointAndCrossAtTheTip) {
    const PieceDart dart = onlyDart(kSlanted.opened());
    const DartMarks marks = dartMarks(dart);
    ASSERT_EQ(marks.fold.rows(), 2);
    EXPECT_EQ(marks.fold.row(0).transpose(), dart.tip);
    EXPECT_EQ(marks.fold.row(1).transpose(), dart.fold.to);
    ASSERT_EQ(marks.drill.rows(), 24);
    for (int k = 0; k < 24; ++k) {
        EXPECT_NEAR((marks.drill.row(k).transpose() - dart.drill).norm(), 1.5, kExactly);
    }
    EXPECT_GT(test::areaOf(marks.drill), 0);
    const Vector2d fold = dart.fold.to - dart.tip;
    for (const Points2& stroke : marks.cross) {
        EXPECT_NEAR((stroke.row(1) - stroke.row(0)).norm(), 5, kExactly);
        EXPECT_LT((stroke.colwise().mean().transpose() - dart.tip).norm(), kExactly);
    }
    EXPECT_NEAR(geometry::cross(marks.cross[0].row(1) - marks.cross[0].row(0), fold.transpose()), 0,
                1e-6);
    EXPECT_NEAR((marks.cross[1].row(1) - marks.cross[1].row(0)).dot(fold.transpose()), 0, 1e-6);
}

TEST(DartMarks, DrillPointOfAShortDartIsAThirdOfItsLegBeforeTheTip) {
    ClosedDart shape = kSquare;
    shape.tip.y() = 24;
    const PieceDart dart = onlyDart(shape.opened());
    EXPECT_NEAR((dart.drill - dart.tip).norm(), 8, kExactly);
}

Pattern cutPattern(const std::string& sample, const SeamsFile& seams) {
    LoadOptions options;
    options.seams = seams;
    Progress progress;
    auto garment = loadGarment({test::dataFile(sample)}, options, progress);
    EXPECT_TRUE(garment);
    return garment ? makePattern(*garment, flattenGarment(*garment, {}, progress)) : Pattern{};
}

TEST(DartsOfGarments, OfATShirtAreLaidTowardsItsCentreWithLegsOfEqualLength) {
    const auto seams = readSeamsFile(test::sourceFile("resources/samples/tshirt.seams.json"));
    ASSERT_TRUE(seams);
    std::size_t found = 0;
    for (const PatternPiece& piece : cutPattern("samples/tshirt.obj", *seams).pieces) {
        SCOPED_TRACE(piece.name);
        const std::vector<PieceDart> darts = findDarts(piece);
        found += darts.size();
        for (const PieceDart& dart : darts) {
            EXPECT_NEAR(dart.leg, dart.to - dart.from - dart.leg, 1e-6);
            EXPECT_GT(dart.leg, 200);
        }
        expectSoundLine(piece, darts);
        if (darts.size() == 2) {
            for (const bool isFirst : {false, true}) {
                const PieceDart& dart = darts[isFirst ? 0 : 1];
                const Vector2d other = darts[isFirst ? 1 : 0].tip;
                const bool firstIsNearer =
                    (dart.mouth.from - other).norm() < (dart.mouth.to - other).norm();
                EXPECT_EQ(dart.lay, firstIsNearer ? DartLay::First : DartLay::Second);
            }
        }
    }
    EXPECT_EQ(found, 2U);
}

TEST(DartsOfGarments, OfACapFoldOntoItsHem) {
    SeamsFile seams;
    seams.cuts = {
        {"dart", UserCut::Kind::Dart, {{57.6259, 1640, 70.4318}, {45.803, 1695.11, 76.353}}}};
    const Pattern pattern = cutPattern("samples/cap.obj", seams);
    const auto piece = std::ranges::find(pattern.pieces, "front_left", &PatternPiece::name);
    ASSERT_NE(piece, pattern.pieces.end());
    const PieceDart dart = onlyDart(*piece);
    EXPECT_NEAR(dart.leg, dart.to - dart.from - dart.leg, 1e-6);
    EXPECT_GT(dart.intake, 15);
    EXPECT_GT(dart.angle, 0.25);
    expectSoundLine(*piece, {dart});
    EXPECT_LT(test::outside(dart.drill.transpose(), cappedOutline(*piece, {dart}).line), 0);
    EXPECT_GT(test::outside(dart.drill.transpose(), piece->outline), 0);
    expectOnSeamLine(*piece, dart, 0.2);  // the legs are curved
}

}  // namespace
}  // namespace toile
