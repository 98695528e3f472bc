// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/readers/plt_read_back.h"
#include "tests/core/support/generator.h"

namespace toile {
namespace {

double plotLengthOf(const Points2& line) {
    double length = 0;
    for (Eigen::Index k = 0; k + 1 < line.rows(); ++k) {
        length += (line.row(k + 1) - line.row(k)).norm();
    }
    return length;
}

/// A closed line of many short steps whose bends change.
Points2 wavyPlotPanel(int count, double radius, unsigned seed) {
    test::Generator random(seed);
    const double phase = random.unit(), depth = random.between(0.02, 0.2);
    Points2 line(count, 2);
    for (int k = 0; k < count; ++k) {
        const double turn = 2 * std::numbers::pi * (k + phase) / count;
        const double reach = radius * (1 + depth * std::cos(3 * turn) + depth * std::sin(5 * turn));
        line.row(k) << 2 * radius + reach * std::cos(turn), 2 * radius + reach * std::sin(turn);
    }
    return line;
}

/// One piece with this outline, every quarter of which is the side of a seam.
Drawing plotPanelDrawing(const Points2& outline) {
    Drawing drawing;
    drawing.title = "panel";
    drawing.width = std::ceil(outline.col(0).maxCoeff()) + 10;
    drawing.height = std::ceil(outline.col(1).maxCoeff()) + 10;
    drawing.paths.push_back({"piece-panel-cut", LayerKind::Cut, outline, true});
    Points2 whole(outline.rows() + 1, 2);
    whole << outline, outline.row(0);
    for (int side = 0; side < 4; ++side) {
        const Eigen::Index from = side * outline.rows() / 4, to = (side + 1) * outline.rows() / 4;
        const Points2 part = whole.middleRows(from, to - from + 1);
        const double start = plotLengthOf(whole.topRows(from + 1));
        drawing.edges.push_back({.id = "edge-" + std::to_string(side),
                                 .pair = "",
                                 .seam = "side",
                                 .number = side,
                                 .path = 0,
                                 .from = start,
                                 .to = start + plotLengthOf(part),
                                 .points = part,
                                 .length3d = plotLengthOf(part)});
    }
    drawing.blocks.push_back({.id = "piece-panel", .piece = 0, .pathCount = 1, .edgeCount = 4});
    return drawing;
}

TEST(PlotterLine, IsWholeAndEndsWhereItBegan) {
    for (const int count : {3, 40, 3000}) {
        const Points2 units = plotterLine(wavyPlotPanel(count, 150, 1), true);
        EXPECT_EQ(units, units.array().round().matrix());
        EXPECT_EQ(units.row(0), units.row(units.rows() - 1));
        EXPECT_LE(units.rows(), count + 1);
    }
    Points2 open(3, 2);
    open << 0.01, 0.01, 10.004, 0.02, 10.004, 5;
    const Points2 units = plotterLine(open, false);
    ASSERT_EQ(units.rows(), 3);
    EXPECT_EQ(units.row(2), Eigen::RowVector2d(400, 200));
    EXPECT_EQ(plotterLine(open.topRows(1), false).rows(), 1);
}

TEST(PlotterLine, FineLinesKeepTheirLength) {
    for (unsigned seed = 1; seed < 6; ++seed) {
        const Points2 line = wavyPlotPanel(20'000, 300, seed);
        Points2 whole(line.rows() + 1, 2);
        whole << line, line.row(0);
        EXPECT_NEAR(plotLengthOf(plotterLine(line, true)) / kPlotterUnits, plotLengthOf(whole),
                    0.045);
    }
}

TEST(PlotterLine, TinyAndRepeatedPointsDoNoHarm) {
    const Points2 dot = Points2::Constant(500, 2, 7.003);
    for (const bool closed : {false, true}) {
        const Points2 units = plotterLine(dot, closed);
        EXPECT_GE(units.rows(), 2);
        EXPECT_EQ(units, Points2::Constant(units.rows(), 2, 280));
    }
    const Points2 units = plotterLine(wavyPlotPanel(1000, 0.05, 3), true);
    EXPECT_EQ(units.row(0), units.row(units.rows() - 1));
}

TEST(WritePlt, PensAndInstructionsAreThoseOfTheStandard) {
    const std::string bytes = writePlt(test::sewingDrawing());
    EXPECT_TRUE(bytes.starts_with("IN;PA;SP"));
    EXPECT_TRUE(bytes.ends_with("PU;PU0,0;SP0;"));
    EXPECT_EQ(bytes.find_first_not_of("INPASUD0123456789,;"), std::string::npos)
        << "whole numbers, none negative";
    EXPECT_LT(bytes.find("SP2;"), bytes.find("SP1;")) << "what is cut comes last";
    std::size_t at = 0;
    while ((at = bytes.find("PD", at)) != std::string::npos) {
        const std::size_t end = bytes.find(';', at);
        EXPECT_LE(std::count(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                             bytes.begin() + static_cast<std::ptrdiff_t>(end), ','),
                  127);
        at = end;
    }
}

TEST(WritePlt, CheckSquareIsAHundredMillimetres) {
    const auto plot = readPlt(writePlt(draw(Pattern{}, Marker{})));
    ASSERT_TRUE(plot);
    Eigen::VectorXd sides;
    for (const PltLine& line : *plot) {
        if (line.pen == 2) {
            sides = test::edgeLengths(line.points);
        }
    }
    EXPECT_EQ(sides, Eigen::VectorXd::Constant(4, 100));
}

TEST(WritePlt, IsReadAsItWasMeantBothWays) {
    for (const bool turned : {false, true}) {
        const Drawing drawing = test::sewingDrawing();
        const auto found = readBackPlt(writePlt(drawing, {turned}), drawing, {turned});
        ASSERT_TRUE(found) << sentence(found.error());
        EXPECT_EQ(found->pieces, static_cast<int>(drawing.blocks.size()));
        EXPECT_FALSE(readBackPlt(writePlt(drawing, {turned}), drawing, {!turned}));
    }
}

TEST(WritePlt, SidesOfSeamsKeepTheirLength) {
    for (unsigned seed = 1; seed < 12; ++seed) {
        for (const int count : {12, 300, 6000}) {
            const Drawing drawing = plotPanelDrawing(wavyPlotPanel(count, 200, seed));
            const auto found = readBackPlt(writePlt(drawing), drawing, {});
            ASSERT_TRUE(found) << sentence(found.error());
            EXPECT_EQ(found->seams, 4);
            EXPECT_LT(found->largest, 0.04);
        }
    }
}

TEST(WritePlt, HolesAreNoPiecesAndCutBeforeTheirOutline) {
    Drawing drawing = plotPanelDrawing(test::rectangle(10, 10, 200, 100));
    drawing.edges.clear();
    drawing.blocks[0].edgeCount = 0;
    drawing.blocks[0].pathCount = 2;
    drawing.paths.push_back(
        {"piece-panel--hole-1", LayerKind::Cut, test::rectangle(50, 50, 20, 20), true});
    const std::string bytes = writePlt(drawing);
    EXPECT_LT(bytes.find("PU2000,2000;"), bytes.find("PU400,400;"));
    const auto found = readBackPlt(bytes, drawing, {});
    ASSERT_TRUE(found) << sentence(found.error());
    EXPECT_EQ(found->pieces, 1);
}

/// A person may lay a cuff on a sleeve: the file says nothing of which line is whose.
TEST(WritePlt, PiecesThatLieOnEachOtherAreReadAsTwo) {
    Drawing drawing = plotPanelDrawing(test::rectangle(10, 10, 200, 100));
    drawing.edges.clear();
    drawing.blocks[0].edgeCount = 0;
    drawing.paths.push_back(
        {"piece-cuff-cut", LayerKind::Cut, test::rectangle(50, 50, 20, 20), true});
    drawing.blocks.push_back(drawing.blocks[0]);
    drawing.blocks[1].path = 1;
    const auto found = readBackPlt(writePlt(drawing), drawing, {});
    ASSERT_TRUE(found) << sentence(found.error());
    EXPECT_EQ(found->pieces, 2);
}

TEST(WritePlt, DifferencesAreFound) {
    const Drawing drawing = test::sewingDrawing();
    const std::string bytes = writePlt(drawing);
    const std::size_t cut = bytes.find("SP1;PU") + 6;
    for (std::string other :
         {bytes.substr(0, cut), bytes + "SP1;PU0,0;PD100,100;PU;", bytes + "SP2;PU0,0;PD0,-400;PU;",
          std::string(bytes).insert(cut, "1"), std::string(bytes).replace(cut - 4, 1, "2"),
          std::string(bytes).insert(6, "SC0,1,0,1;"), std::string()}) {
        const auto found = readBackPlt(other, drawing, {});
        ASSERT_FALSE(found);
        EXPECT_EQ(found.error().code, ErrorCode::NotReadBack);
    }
}

TEST(WritePlt, GivesTheSameBytesTwiceAndInAnyLocale) {
    const std::string bytes = writePlt(test::sewingDrawing());
    const test::CommaLocale comma;
    EXPECT_EQ(bytes, writePlt(test::sewingDrawing()));
}

}  // namespace
}  // namespace toile
