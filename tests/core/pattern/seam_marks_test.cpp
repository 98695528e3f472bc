// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/export/drawing.h"
#include "core/export/writers.h"
#include "tests/core/export/export_fixtures.h"

namespace toile {
namespace {

/// A rectangle of 200 x 100 mm, sewn along its lower edge and, over a corner, along the other
/// three.
PatternPiece sewnRectangle() {
    PatternPiece piece{{}, "front", "front", test::rectangle(0, 0, 200, 100)};
    SeamLine lower{1, "front / back", Points2(3, 2), false};
    lower.line << 0, 0, 90, 0, 200, 0;
    SeamLine rest{12, "front / a sleeve with a very long name", Points2(4, 2), false};
    rest.line << 200, 0, 200, 100, 0, 100, 0, 0;
    piece.seams = {lower, rest};
    return piece;
}

Drawing marked(const PatternPiece& piece) {
    Drawing drawing = draw({"", {piece}}, {{{0, {{990, -10}}}}, 0, 0});  // but for the margin
    std::erase_if(drawing.paths, [](const auto& path) { return path.layer != LayerKind::Marks; });
    std::erase_if(drawing.texts, [](const auto& text) { return text.layer != LayerKind::Marks; });
    return drawing;
}

TEST(SeamMarks, TickTheEndsOfASeamIntoTheCloth) {
    const Drawing drawing = marked(sewnRectangle());
    ASSERT_EQ(drawing.paths.size(), 4U);
    for (const DrawnPath& tick : drawing.paths) {
        EXPECT_EQ(tick.layer, LayerKind::Marks);
        EXPECT_FALSE(tick.closed);
        ASSERT_EQ(tick.points.rows(), 2);
        EXPECT_NEAR((tick.points.row(1) - tick.points.row(0)).norm(), 5, 1e-12);
    }
    Points2 first(2, 2);
    first << 1000, 0, 1000, 5;
    EXPECT_TRUE(drawing.paths[0].points.isApprox(first, 1e-12));
    first << 1200, 0, 1200, 5;
    EXPECT_TRUE(drawing.paths[1].points.isApprox(first, 1e-12));
    first << 1200, 0, 1195, 0;
    EXPECT_TRUE(drawing.paths[2].points.isApprox(first, 1e-12));
    EXPECT_EQ(drawing.paths[2].id, "piece-front--seam-12-tick-1");
}

TEST(SeamMarks, NameTheSeamAtItsMiddleInsideTheCloth) {
    const Drawing drawing = marked(sewnRectangle());
    ASSERT_EQ(drawing.texts.size(), 2U);
    EXPECT_EQ(drawing.texts[0].lines, std::vector<std::string>{"1  front / back"});
    EXPECT_EQ(drawing.texts[0].angle, 0);
    EXPECT_NEAR(drawing.texts[0].position.x(), 1100, 1e-9);
    EXPECT_GT(drawing.texts[0].position.y(), 1.25);
    EXPECT_LT(drawing.texts[0].position.y(), 6);
    // The middle of the other one is on the upper edge: below it, and not upside down.
    EXPECT_NEAR(drawing.texts[1].position.x(), 1100, 1e-9);
    EXPECT_LT(drawing.texts[1].position.y(), 100);
    EXPECT_NEAR(drawing.texts[1].angle, 0, 1e-12);
}

TEST(SeamMarks, GiveTheNumberAloneWhereTheNameIsTooLong) {
    PatternPiece piece = sewnRectangle();
    piece.seams[0].line *= 0.1;  // 20 mm
    const Drawing drawing = marked(piece);
    EXPECT_EQ(drawing.texts[0].lines, std::vector<std::string>{"1"});
    piece.seams[0].line *= 0.01;  // 0.2 mm: nothing could be read
    EXPECT_EQ(marked(piece).texts.size(), 1U);
}

TEST(SeamMarks, AreNoCutLinesAndTellTwoSidesOfOnePieceApart) {
    PatternPiece piece = sewnRectangle();
    piece.seams[1].number = 1;
    Pattern pattern{"sleeve", {piece}};
    const Drawing drawing = draw(pattern, layOut(pattern));
    EXPECT_EQ(drawing.paths.size(), 6U);
    EXPECT_EQ(drawing.paths[3].id, "piece-front--seam-1b-tick-1");
    const std::string svg = writeSvg(drawing);
    EXPECT_NE(svg.find("id=\"layer-marks\""), std::string::npos);
    const std::string dxf = writeDxf(drawing);
    EXPECT_NE(dxf.find("\r\n  8\r\nMARKS\r\n"), std::string::npos);
}

TEST(SeamMarks, TextAlongAStandingEdgeIsTurned) {
    PatternPiece piece = sewnRectangle();
    piece.seams.resize(1);
    piece.seams[0].line.resize(2, 2);
    piece.seams[0].line << 200, 0, 200, 100;
    const Drawing drawing = marked(piece);
    EXPECT_NEAR(drawing.texts[0].angle, 0.5 * std::numbers::pi, 1e-12);
    EXPECT_LT(drawing.texts[0].position.x(), 1200);
    EXPECT_NE(writeSvg(drawing).find("rotate(-90.0000 "), std::string::npos);
    EXPECT_NE(writeDxf(drawing).find("\r\n 50\r\n90.0000\r\n"), std::string::npos);
}

}  // namespace
}  // namespace toile
