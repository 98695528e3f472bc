// SPDX-License-Identifier: GPL-3.0-or-later
// Darts opened as typed in outlines whose shape is known.
#include "core/pattern/reshaped_outline.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/pattern/fair_outline.h"
#include "tests/core/pattern/dart_shapes.h"

namespace toile {
namespace {

constexpr double kSameOutline = 1e-9;  // mm

OutlineReference asReference(const Points2& outline) {
    const auto line = geometry::Line::closed(outline);
    OutlineReference reference{outline, line.arc().values(), {}};
    for (int k = 0; k < line.count(); ++k) {
        reference.turn.push_back(line.turnAt(k));
    }
    return reference;
}

OutlinePlan::Dart dartOf(const PatternPiece& piece, double intake) {
    OutlinePlan::Dart dart;
    dart.piece = 0;
    dart.from = piece.seams[0].from;
    dart.tip = piece.seams[0].to;
    dart.to = dart.tip + piece.seams[1].to - piece.seams[1].from;
    dart.intake = intake;
    return dart;
}

/// A sector of a disk without the part of it from 0.4 to `gap` later, radians: what a cone with
/// one dart from its rim to its apex lies flat as; the sector is its own dart.
test::Corners disk(double radius, double gap, int count) {
    test::Corners outline{{0, 0}};
    for (int k = 0; k <= count; ++k) {
        const double at = 0.4 + gap + (2 * std::numbers::pi - gap) * k / count;
        outline.emplace_back(radius * std::cos(at), radius * std::sin(at));
    }
    return outline;
}

const test::ClosedDart kUpright{
    {{-300, 0}, {-150, 0}}, {0, 0}, {0, 120}, {{150, 0}, {300, 0}}, 0.3};
const test::ClosedDart kCurved{{{-300, 0}}, {0, 0}, {10, 120},
                               {{300, 0}},  0.25,   {{6, 40}, {9, 80}}};

void expectOpened(const OutlineReference& made, const OutlineReference& before,
                  const OutlinePlan::Dart& dart) {
    const auto line = geometry::Line::closed(made.points, made.arc);
    const auto exact = geometry::Line::closed(before.points, before.arc);
    const Eigen::RowVector2d from = line.pointAt(dart.from), tip = line.pointAt(dart.tip),
                             to = line.pointAt(dart.to);
    EXPECT_NEAR((to - from).norm(), dart.intake, kSameOutline);
    EXPECT_NEAR((tip - from).norm(), dart.firstLeg(), kSameOutline);
    EXPECT_NEAR((tip - to).norm(), dart.secondLeg(), kSameOutline);
    ASSERT_EQ(made.arc.size(), static_cast<std::size_t>(made.points.rows()) + 1);
    for (Eigen::Index k = 0; k < made.points.rows(); ++k) {
        const double length = made.arc[k + 1] - made.arc[k];
        EXPECT_GT(length, 0);
        const Eigen::RowVector2d edge =
            made.points.row((k + 1) % made.points.rows()) - made.points.row(k);
        EXPECT_NEAR(edge.norm(), length, kSameOutline) << k;
    }
    EXPECT_EQ(made.arc.front(), 0);
    EXPECT_EQ(made.arc.back(), before.arc.back());
}

TEST(TypedDartOutlines, HaveTheIntakeAndEveryLength) {
    for (const test::ClosedDart& shape : {kUpright, kCurved}) {
        const PatternPiece opened = shape.opened();
        for (int start = 0; start < opened.outline.rows(); ++start) {
            for (const double intake : {0.1, 5.0, 60.0, 180.0}) {
                SCOPED_TRACE(std::to_string(start) + ", " + std::to_string(intake));
                const PatternPiece piece = test::begunAt(opened, start);
                const OutlineReference before = asReference(piece.outline);
                OutlinePlan plan;
                plan.darts = {dartOf(piece, intake)};
                const auto made = reshapedOutline(before, plan, {});
                ASSERT_TRUE(made);
                expectOpened(*made, before, plan.darts.front());
            }
        }
    }
}

TEST(TypedDartOutlines, StayAsTheyAreWithTheIntakeThatTheyHave) {
    constexpr double kRadius = 200;
    for (const double gap : {0.1, 0.7, 2.0}) {
        const test::Corners corners = disk(kRadius, gap, 60);
        const int last = static_cast<int>(corners.size()) - 1;
        const PatternPiece piece = test::pieceWithDarts(corners, {{last, 0, 1}}, {});
        const OutlineReference before = asReference(piece.outline);
        OutlinePlan plan;
        plan.darts = {dartOf(piece, 2 * kRadius * std::sin(gap / 2))};
        const auto made = reshapedOutline(before, plan, {});
        ASSERT_TRUE(made);
        EXPECT_LT((made->points - before.points).cwiseAbs().maxCoeff(), 1e-6);
        // What is wider stays symmetric about the fold of the dart.
        plan.darts.front().intake *= 1.1;
        const auto wider = reshapedOutline(before, plan, {});
        ASSERT_TRUE(wider);
        expectOpened(*wider, before, plan.darts.front());
        for (int k = 1; k <= last; ++k) {
            EXPECT_NEAR((wider->points.row(k) - wider->points.row(0)).norm(),
                        (wider->points.row(last + 1 - k) - wider->points.row(0)).norm(), 1e-6);
        }
    }
}

TEST(TypedDartOutlines, OutOfReachOfTheLegsAreRefused) {
    const PatternPiece piece = kUpright.opened();
    const OutlineReference before = asReference(piece.outline);
    OutlinePlan plan;
    for (const double intake : {240.0, 1000.0}) {
        plan.darts = {dartOf(piece, intake)};
        const auto made = reshapedOutline(before, plan, {});
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().code, ErrorCode::LineNotDrawn);
    }
    plan.darts.clear();
    const auto made = reshapedOutline(before, plan, {});
    ASSERT_TRUE(made);
    EXPECT_EQ(*made, before);
}

}  // namespace
}  // namespace toile
