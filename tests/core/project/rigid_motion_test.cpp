// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/rigid_motion.h"

#include <cmath>

#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr double kTight = 1e-9;  // mm

/// Neither symmetric nor centred.
Points2 someShape() {
    Points2 Q(6, 2);
    Q << 10, 20, 110, 25, 130, 90, 60, 140, 5, 100, 40, 60;
    return Q;
}

const std::vector<int> kOutline{0, 1, 2, 3, 4};

Points2 moved(const Points2& Q, double turn, const Eigen::Vector2d& shift) {
    return Placement{shift, turn}.appliedToRows(Q);
}

Eigen::Vector2d grainOnSheet(const PieceSettings& settings) {
    const double grain = grainOf(settings);
    return settings.placement->linear() * Eigen::Vector2d(std::cos(grain), std::sin(grain));
}

PieceSettings turnedSettings(bool mirrored) {
    PieceSettings settings;
    settings.placement = Placement{{300, -40}, 0.7, mirrored};
    settings.grain = 1.1;
    settings.quantity = 3;
    return settings;
}

/// Each vertex lies where it lay, and the grain runs as it ran.
void expectSamePlace(const PieceSettings& before, const Points2& then, const PieceSettings& after,
                     const Points2& now) {
    for (Eigen::Index i = 0; i < then.rows(); ++i) {
        const Eigen::Vector2d was = before.placement->applied(then.row(i).transpose());
        const Eigen::Vector2d is = after.placement->applied(now.row(i).transpose());
        EXPECT_LT((was - is).norm(), kTight) << "vertex " << i;
    }
    EXPECT_LT((grainOnSheet(before) - grainOnSheet(after)).norm(), kTight);
    EXPECT_EQ(before.placement->mirrored, after.placement->mirrored);
    EXPECT_EQ(before.quantity, after.quantity);
}

TEST(RigidMotion, TheBestMotionIsFoundExactlyWhereThereIsOne) {
    const Points2 Q = someShape();
    for (const double turn : {-3.0, -1.0, 0.0, 1e-6, 0.5, 2.0, 3.14}) {
        const Points2 there = moved(Q, turn, {7, -300});
        const RigidMotion motion = bestMotion(Q, there);
        EXPECT_NEAR(std::remainder(motion.turn - turn, 2 * M_PI), 0, kTight);
        EXPECT_LT((moved(Q, motion.turn, motion.offset) - there).norm(), kTight);
    }
}

TEST(RigidMotion, NoOtherMotionIsBetterWhereTheShapesDiffer) {
    const Points2 Q = someShape();
    Points2 other = moved(Q, 0.4, {5, 6});
    other.row(2) += Eigen::RowVector2d(12, -3);
    other.row(4) += Eigen::RowVector2d(-8, 9);
    const RigidMotion best = bestMotion(Q, other);
    const double least = (moved(Q, best.turn, best.offset) - other).squaredNorm();
    for (const double turn : {-1e-3, 0.0, 1e-3}) {
        for (const Eigen::Vector2d& shift :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.1, 0), Eigen::Vector2d(0, -0.1)}) {
            const Points2 there = moved(Q, best.turn + turn, best.offset + shift);
            EXPECT_GE((there - other).squaredNorm(), least);
        }
    }
}

TEST(RigidMotion, PointsWithoutExtentAreOnlyMoved) {
    Points2 one(1, 2), other(1, 2);
    one << 1, 2;
    other << 5, 7;
    const RigidMotion motion = bestMotion(one, other);
    EXPECT_EQ(motion.turn, 0);
    EXPECT_LT((motion.applied({1, 2}) - Eigen::Vector2d(5, 7)).norm(), kTight);
    EXPECT_EQ(bestMotion(Points2(0, 2), Points2(0, 2)).turn, 0);
}

TEST(RigidMotion, APieceStaysOnTheSheetWhenItsOwnCoordinatesTurn) {
    const Points2 then = someShape();
    for (const bool mirrored : {false, true}) {
        for (const double turn : {-2.0, 0.3, 3.0}) {
            const Points2 now = moved(then, turn, {-50, 80});
            const PieceSettings before = turnedSettings(mirrored);
            expectSamePlace(before, then, movedSettings(before, bestMotion(now, then), 300), now);
        }
    }
}

TEST(RigidMotion, SettingsAreTheSameToTheBitWhereNothingMoves) {
    const Points2 Q = someShape();
    const PieceSettings before = turnedSettings(true);
    EXPECT_EQ(movedSettings(before, bestMotion(Q, Q), 200), before);
    PieceSettings anchored = before;
    anchored.anchors = outlineAnchors(kOutline, Q);
    EXPECT_EQ(anchoredSettings(anchored, Q), before);
}

TEST(RigidMotion, AGrainThatIsUnsetStaysUnset) {
    PieceSettings settings = turnedSettings(false);
    settings.grain.reset();
    EXPECT_FALSE(movedSettings(settings, {{{1, 2}, 0.5}}, 100).grain);
}

TEST(AnchoredPlacement, AnchorsBringAPieceBackToItsPlace) {
    const Points2 then = someShape();
    for (const bool mirrored : {false, true}) {
        for (const double turn : {-3.0, -0.2, 1.0}) {
            const Points2 now = moved(then, turn, {500, 20});
            const PieceSettings before = turnedSettings(mirrored);
            PieceSettings saved = before;
            saved.anchors = outlineAnchors(kOutline, then);
            const PieceSettings after = anchoredSettings(saved, now);
            EXPECT_TRUE(after.anchors.empty());
            expectSamePlace(before, then, after, now);
        }
    }
}

TEST(AnchoredPlacement, AnchorsAreSpreadOverTheWholeOutline) {
    const Points2 Q = someShape();
    EXPECT_EQ(outlineAnchors(kOutline, Q).size(), kOutline.size());
    EXPECT_TRUE(outlineAnchors({}, Q).empty());
    // A circle, sampled much more finely on one half.
    std::vector<int> outline;
    Points2 circle(360, 2);
    for (int i = 0; i < 360; ++i) {
        const double angle = i < 300 ? i * M_PI / 300 : M_PI + (i - 300) * M_PI / 60;
        circle.row(i) << 100 * std::cos(angle), 100 * std::sin(angle);
        outline.push_back(i);
    }
    const auto anchors = outlineAnchors(outline, circle);
    ASSERT_EQ(anchors.size(), static_cast<std::size_t>(kOutlineAnchors));
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        EXPECT_EQ(anchors[i].flat, Eigen::Vector2d(circle.row(anchors[i].vertex).transpose()));
        const Anchor& next = anchors[(i + 1) % anchors.size()];
        EXPECT_NE(next.vertex, anchors[i].vertex);
        EXPECT_LT((next.flat - anchors[i].flat).norm(), 1.6 * 2 * M_PI * 100 / kOutlineAnchors);
    }
}

TEST(AnchoredPlacement, APieceWithoutASetTurnKeepsItsTurnToTheBit) {
    const Points2 then = someShape();
    for (const bool mirrored : {false, true}) {
        for (const double turn : {-0.3, 0.001, 1.0}) {
            const Points2 now = moved(then, turn, {500, 20});
            PieceSettings before;
            before.placement = Placement{{300, -40}, 0, mirrored};
            before.anchors = outlineAnchors(kOutline, then);
            const PieceSettings after = anchoredSettings(before, now);
            EXPECT_EQ(after.placement->turn, 0);
            EXPECT_FALSE(after.grain);
            Eigen::Vector2d moves = Eigen::Vector2d::Zero();
            for (const int v : kOutline) {
                moves += after.placement->applied(now.row(v).transpose()) -
                         before.placement->applied(then.row(v).transpose());
            }
            EXPECT_LT(moves.norm(), kTight);
            // A grain that was stated stays on the cloth.
            before.grain = 1.1;
            EXPECT_NEAR(*anchoredSettings(before, now).grain, 1.1 + turn, kTight);
        }
    }
}

TEST(AnchoredPlacement, AnUnturnedPieceIsTurnedWhereItWouldElseGetTooFarFromItsPlace) {
    const Points2 then = someShape();
    PieceSettings before;
    before.placement = Placement{{300, -40}};
    before.anchors = outlineAnchors(kOutline, then);
    const Points2 little = moved(then, 1e-4, {0, 0}), much = moved(then, 0.1, {0, 0});
    EXPECT_EQ(anchoredSettings(before, little, 1).placement->turn, 0);
    PieceSettings wanted = before;
    wanted.grain = kGrainUpwards;
    PieceSettings turned = before;
    turned.grain = kGrainUpwards;
    expectSamePlace(wanted, then, anchoredSettings(turned, much, 1), much);
}

TEST(AnchoredPlacement, OneOddAnchorDoesNotTurnAPiece) {
    // Two far points decide nothing: the piece lies where its whole outline fits best.
    const Points2 then = someShape();
    PieceSettings before = turnedSettings(false);
    before.anchors = outlineAnchors(kOutline, then);
    Points2 now = then;
    now.row(3) += Eigen::RowVector2d(4, -3);
    const PieceSettings after = anchoredSettings(before, now);
    const auto distance = [&](const PieceSettings& settings) {
        double sum = 0;
        for (const int v : kOutline) {
            sum += (settings.placement->applied(now.row(v).transpose()) -
                    before.placement->applied(then.row(v).transpose()))
                       .squaredNorm();
        }
        return sum;
    };
    for (const double turn : {-1e-3, 0.0, 1e-3}) {
        PieceSettings other = after;
        other.placement->turn += turn;
        EXPECT_GE(distance(other), distance(after) - kTight);
    }
    EXPECT_NEAR(*anchorResidual(before.anchors, then), 0, kTight);
    EXPECT_GT(*anchorResidual(before.anchors, now), 1);
    EXPECT_LE(*anchorResidual(before.anchors, now), 5);
}

TEST(AnchoredPlacement, AnchorsOfAnotherMeshAreNotFollowed) {
    const Points2 Q = someShape();
    PieceSettings settings = turnedSettings(false);
    const PieceSettings before = settings;
    settings.anchors = {{0, {0, 0}}, {600, {10, 10}}};
    EXPECT_EQ(anchoredSettings(settings, Q), before);
    settings.anchors = {{-1, {0, 0}}, {1, {10, 10}}};
    EXPECT_EQ(anchoredSettings(settings, Q), before);
    settings.anchors = {{0, {0, 0}}, {1, {9000, 10}}};  // they were never so far apart
    EXPECT_EQ(anchoredSettings(settings, Q), before);
    settings.anchors = {{0, {NAN, 0}}, {1, {9, 10}}};
    EXPECT_EQ(anchoredSettings(settings, Q), before);
}

}  // namespace
}  // namespace toile
