// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "core/pattern/piece_grain.h"
#include "tests/core/formats/dxf_reader.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

constexpr double kPi = std::numbers::pi;

bool isInside(const Points2& outline, const Eigen::Vector2d& point) {
    bool inside = false;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Eigen::Vector2d a = outline.row(i), b = outline.row((i + 1) % outline.rows());
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            inside = !inside;
        }
    }
    return inside;
}

TEST(GrainLine, LiesInsideAlongItsDirection) {
    for (const PatternPiece& piece : test::sewingPattern().pieces) {
        for (const double angle : {0.0, 0.4, kPi / 2, 2.5}) {
            const auto line = grainLine({{piece.outline}}, angle);
            if (!line) {
                continue;  // no room for one
            }
            const Eigen::Vector2d way = (line->to - line->from).normalized();
            EXPECT_LT((way - Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm(), 1e-9);
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                EXPECT_TRUE(isInside(piece.outline, line->from + share * (line->to - line->from)))
                    << piece.name << angle;
            }
        }
    }
}

TEST(GrainLine, RunsThroughTheMiddleWhereNothingIsInItsWay) {
    for (const double angle : {0.0, 0.4, kPi / 2}) {
        // Lines beside the middle of a rectangle are as long as it at best.
        const auto line = grainLine({{test::rectangle(-70, 30, 200, 300)}}, angle);
        ASSERT_TRUE(line);
        EXPECT_LT((0.5 * (line->from + line->to) - Eigen::Vector2d(30, 180)).norm(), 1e-9) << angle;
    }
}

TEST(GrainLine, KeepsAwayFromTheOutlineAndIsNoLongerThanNeeded) {
    // The longest line of all runs along the right edge; one as long as is drawn fits well inside.
    Points2 outline(4, 2);
    outline << 0, 0, 300, 0, 300, 1000, 0, 700;
    const auto line = grainLine({{outline}}, kPi / 2);
    ASSERT_TRUE(line);
    EXPECT_NEAR((line->to - line->from).norm(), 300, 1e-9);
    EXPECT_GT(line->from.x(), 100);
    EXPECT_LT(line->from.x(), 200);
    // A strip: along it as far as a tenth of the length leaves room, across it nearly all.
    const auto along = grainLine({{test::rectangle(0, 0, 20, 600)}}, kPi / 2);
    ASSERT_TRUE(along);
    EXPECT_NEAR((along->to - along->from).norm(), 160, 1e-9);
    const auto across = grainLine({{test::rectangle(0, 0, 20, 600)}}, 0);
    ASSERT_TRUE(across);
    EXPECT_NEAR((across->to - across->from).norm(), 16, 1e-9);
}

TEST(GrainLine, KeepsOffTheName) {
    const Points2 outline = test::rectangle(0, 0, 200, 300);
    Points2 name(5, 2);
    name << 60, 140, 140, 140, 140, 160, 60, 160, 60, 140;
    const auto line = grainLine({{outline}, {name}}, kPi / 2);
    ASSERT_TRUE(line);
    EXPECT_TRUE(line->from.x() < 60 || line->from.x() > 140);
    EXPECT_GT((line->to - line->from).norm(), 150);
    name << -1, -1, 201, -1, 201, 301, -1, 301, -1, -1;
    EXPECT_FALSE(grainLine({{outline}, {name}}, kPi / 2));
    EXPECT_FALSE(grainLine({{Points2(0, 2)}}, 0));
    EXPECT_FALSE(grainLine({{outline}}, std::numeric_limits<double>::quiet_NaN()));
}

TEST(GrainLine, KeepsOffHoles) {
    const Points2 outline = test::rectangle(0, 0, 200, 300),
                  hole = test::rectangle(80, 100, 40, 90);
    const auto line = grainLine({{outline, hole}}, kPi / 2);
    ASSERT_TRUE(line);
    EXPECT_TRUE(line->from.x() < 80 || line->from.x() > 120);
    EXPECT_GT((line->to - line->from).norm(), 200);
}

TEST(GrainLine, IsDrawnOnALayerOfItsOwnWhereStated) {
    Pattern pattern = test::sewingPattern();
    EXPECT_EQ(
        test::DxfFile(writePlainDxf(draw(pattern, placeCopies(pattern)))).layers.count("GRAIN"),
        0U);
    pattern.pieces[0].grain = 0.5;
    const Drawing drawing = draw(pattern, placeCopies(pattern, {Placement{{0, 0}, 0.3, true}}));
    const test::DxfFile file(writePlainDxf(drawing));
    EXPECT_TRUE(file.faults.empty());
    EXPECT_EQ(file.layers.count("GRAIN"), 1U);
    int lines = 0;
    for (const auto& line : file.polylines) {
        if (line.layer == "GRAIN") {
            ++lines;
            EXPECT_FALSE(line.closed);
            const Eigen::RowVector2d way = line.points[1] - line.points[0];
            EXPECT_NEAR(std::atan2(way.y(), way.x()), kPi - 0.5 + 0.3, 1e-3);
        }
    }
    EXPECT_EQ(lines, 1);
    const std::string svg = writeSvg(drawing);
    EXPECT_NE(svg.find("layer-grain"), std::string::npos);
    EXPECT_NE(svg.find("wrong side of the fabric up"), std::string::npos);
}

}  // namespace
}  // namespace toile
