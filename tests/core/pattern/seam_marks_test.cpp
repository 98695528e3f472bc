// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/formats/drawing/drawing.h"
#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"

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

TEST(SeamMarks, NumberAndNameTheSeamAtItsMiddleInsideTheCloth) {
    const Drawing drawing = marked(sewnRectangle());
    ASSERT_EQ(drawing.texts.size(), 4U);
    const DrawnText &number = drawing.texts[0], &name = drawing.texts[1];
    EXPECT_EQ(number.id, "piece-front--seam-1-number");
    EXPECT_EQ(number.lines, std::vector<std::string>{"1"});
    EXPECT_EQ(number.height, 6);
    EXPECT_EQ(name.id, "piece-front--seam-1-name");
    EXPECT_EQ(name.lines, std::vector<std::string>{"front / back"});
    EXPECT_EQ(name.height, 2.5);
    for (const DrawnText* text : {&number, &name}) {
        EXPECT_EQ(text->angle, 0);
        EXPECT_GT(text->position.y(), 3);
        EXPECT_LT(text->position.y(), 12);
    }
    EXPECT_EQ(number.position.y(), name.position.y());
    // Together they are at the middle, the number first.
    const double left = number.position.x() - 0.5 * textExtent(number.lines, 6).x();
    const double right = name.position.x() + 0.5 * textExtent(name.lines, 2.5).x();
    EXPECT_NEAR(0.5 * (left + right), 1100, 1e-9);
    // The middle of the other one is on the upper edge: below it, and not upside down.
    EXPECT_EQ(drawing.texts[2].lines, std::vector<std::string>{"12"});
    EXPECT_LT(drawing.texts[2].position.y(), 100);
    EXPECT_NEAR(drawing.texts[2].angle, 0, 1e-12);
    EXPECT_LT(drawing.texts[2].position.x(), drawing.texts[3].position.x());
}

TEST(SeamMarks, GiveTheNumberAloneWhereTheNameIsTooLong) {
    PatternPiece piece = sewnRectangle();
    piece.seams[0].line *= 0.1;  // 20 mm
    const Drawing drawing = marked(piece);
    EXPECT_EQ(drawing.texts[0].lines, std::vector<std::string>{"1"});
    EXPECT_EQ(drawing.texts[0].height, 6);
    EXPECT_EQ(drawing.texts[1].lines, std::vector<std::string>{"12"});
    piece.seams[0].line *= 0.12;  // 2.4 mm: not so large
    EXPECT_EQ(marked(piece).texts[0].height, 2);
    piece.seams[0].line *= 0.1;  // 0.2 mm: nothing could be read
    EXPECT_EQ(marked(piece).texts[0].lines, std::vector<std::string>{"12"});
}

TEST(SeamMarks, NumbersThatTurnIntoOthersUpsideDownEndInADot) {
    const auto written = [](int number, const char* name) {
        SeamMark mark;
        mark.number = number;
        mark.name = name;
        return numberText(mark);
    };
    for (const int number : {6, 9, 66, 68, 86, 89, 98, 99, 606, 669}) {
        EXPECT_EQ(written(number, ""), std::to_string(number) + ".");
        EXPECT_EQ(written(number, "front / back"), std::to_string(number));
    }
    for (const int number : {1, 2, 8, 10, 12, 26, 60, 69, 88, 90, 96, 609, 906}) {
        EXPECT_EQ(written(number, ""), std::to_string(number));
    }
    PatternPiece piece = sewnRectangle();
    piece.seams[0].number = 6;
    EXPECT_EQ(marked(piece).texts[0].lines, std::vector<std::string>{"6"});  // its name follows
    piece.seams[0].line *= 0.1;
    EXPECT_EQ(marked(piece).texts[0].lines, std::vector<std::string>{"6."});
}

TEST(SeamMarks, LieAlongStraightStretchesRatherThanAcrossCorners) {
    PatternPiece piece = sewnRectangle();
    piece.seams.erase(piece.seams.begin());
    piece.seams[0].line.resize(3, 2);
    piece.seams[0].line << 200, 0, 200, 100, 100, 100;  // its middle is a corner
    for (const SeamMark& mark : seamMarks(piece, {})) {
        ASSERT_TRUE(mark.numberPlace);
        EXPECT_EQ(mark.numberPlace->height, 6);
        EXPECT_NEAR(std::abs(std::sin(2 * mark.angle)), 0, 1e-9);
    }
}

TEST(SeamMarks, MakeRoomForEachOtherOnANarrowStrip) {
    for (const double width : {30.0, 15.0, 6.0, 3.0}) {
        PatternPiece piece{{}, "band", "band", test::rectangle(0, 0, 300, width)};
        SeamLine lower{1, "band / front", Points2(2, 2), false};
        lower.line << 0, 0, 300, 0;
        SeamLine upper{2, "band / back", Points2(2, 2), false};
        upper.line << 300, width, 0, width;
        piece.seams = {lower, upper};
        const std::vector<SeamMark> marks = seamMarks(piece, {});
        ASSERT_EQ(marks.size(), 2U);
        for (const SeamMark& mark : marks) {
            ASSERT_TRUE(mark.numberPlace) << width;
            const double height = mark.numberPlace->height;
            EXPECT_EQ(height, width > 10 ? 6 : width > 5 ? 3 : 1.5) << width;
            EXPECT_GT(mark.numberPlace->position.y() - 0.5 * height, 0);
            EXPECT_LT(mark.numberPlace->position.y() + 0.5 * height, width);
        }
    }
}

TEST(SeamMarks, AreNoCutLinesAndTellTwoSidesOfOnePieceApart) {
    PatternPiece piece = sewnRectangle();
    piece.seams[1].number = 1;
    Pattern pattern{"sleeve", {piece}};
    const Drawing drawing = draw(pattern, placeCopies(pattern));
    EXPECT_EQ(drawing.paths.size(), 6U);
    EXPECT_EQ(drawing.paths[3].id, "piece-front--seam-1b-tick-1");
    const std::string svg = writeSvg(drawing);
    EXPECT_NE(svg.find("id=\"layer-marks\""), std::string::npos);
    const std::string dxf = writePlainDxf(drawing);
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
    EXPECT_LT(drawing.texts[0].position.y(), drawing.texts[1].position.y());
    EXPECT_NE(writeSvg(drawing).find("rotate(-90.0000 "), std::string::npos);
    EXPECT_NE(writePlainDxf(drawing).find("\r\n 50\r\n90.0000\r\n"), std::string::npos);
}

}  // namespace
}  // namespace toile
