// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/formats/writers.h"
#include "tests/core/formats/dxf_reader.h"
#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

constexpr double kDxfWritten = 2e-4;  // what 4 decimals can change in a length, mm

TEST(WriteDxf, KeepsEveryEdgeLengthToTheWrittenPrecision) {
    const Pattern pattern = test::sewingPattern();
    const test::DxfFile file(writePlainDxf(draw(pattern, placeCopies(pattern))));
    EXPECT_TRUE(file.faults.empty()) << file.faults.front();
    ASSERT_EQ(file.polylines.size(), pattern.pieces.size() + 1);
    for (std::size_t i = 0; i < pattern.pieces.size(); ++i) {
        const test::DxfPolyline& written = file.polylines[i];
        EXPECT_TRUE(written.closed);
        EXPECT_EQ(written.layer, "CUT");
        ASSERT_EQ(written.matrix().rows(), pattern.pieces[i].outline.rows());
        const Eigen::VectorXd error =
            test::edgeLengths(written.matrix()) - test::edgeLengths(pattern.pieces[i].outline);
        EXPECT_LT(error.cwiseAbs().maxCoeff(), kDxfWritten) << i;
    }
    EXPECT_EQ(file.polylines.back().layer, "CHECK");
    EXPECT_EQ(test::edgeLengths(file.polylines.back().matrix()), Eigen::VectorXd::Constant(4, 100));
}

TEST(WriteDxf, LeavesYUpAndTheDrawingWithinItsExtents) {
    const Drawing drawing = test::sewingDrawing();
    const test::DxfFile file(writePlainDxf(drawing));
    for (std::size_t i = 0; i < drawing.paths.size(); ++i) {
        const Points2 error = file.polylines[i].matrix() - drawing.paths[i].points;
        EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-4);
    }
    EXPECT_EQ(file.header.at("$EXTMAX")[0].value, fixed(drawing.width, 4));
    EXPECT_EQ(file.header.at("$EXTMAX")[1].value, fixed(drawing.height, 4));
    EXPECT_EQ(file.header.at("$EXTMIN")[0].value, "0.0000");
}

TEST(WriteDxf, IsPlainMetricR12WithoutBlocks) {
    const test::DxfFile file(writePlainDxf(test::sewingDrawing()));
    EXPECT_EQ(file.header.at("$ACADVER")[0].value, "AC1009");
    EXPECT_EQ(file.header.at("$MEASUREMENT")[0].value, "1");
    EXPECT_EQ(file.header.at("$INSUNITS")[0].value, "4");
    EXPECT_EQ(file.blocks, 0);
    EXPECT_EQ(file.layers,
              (std::map<std::string, int>{{"CUT", 1}, {"MARKS", 3}, {"TEXT", 7}, {"CHECK", 5}}));
}

TEST(WriteDxf, WritesNamesInAscii) {
    Drawing drawing = test::sewingDrawing();
    drawing.texts[2].lines[0] = "50%% cotton ^I\n";
    const test::DxfFile file(writePlainDxf(drawing));
    EXPECT_TRUE(file.faults.empty()) << file.faults.front();
    ASSERT_EQ(file.texts.size(), 9u);
    EXPECT_EQ(file.texts[0].value, "Armel <links> & \"rechts\"");
    EXPECT_EQ(file.texts[1].value, "seam line, no allowance");
    EXPECT_EQ(file.texts[2].value, "___");
    EXPECT_EQ(file.texts[4].value, "50_% cotton _I_");
    EXPECT_EQ(file.texts[0].layer, "TEXT");
    EXPECT_EQ(file.texts.back().value, "check square 100 mm x 100 mm");
    EXPECT_EQ(file.texts.back().layer, "CHECK");
    for (const test::DxfText& text : file.texts) {
        EXPECT_GE(text.height, 1.5);
        EXPECT_GT(text.middle.minCoeff(), 0);
    }
}

TEST(WriteDxf, GivesTheSameBytesTwiceAndInAnyLocale) {
    const std::string bytes = writePlainDxf(test::sewingDrawing());
    EXPECT_EQ(bytes, writePlainDxf(test::sewingDrawing()));
    const test::CommaLocale comma;
    EXPECT_EQ(bytes, writePlainDxf(test::sewingDrawing()));
}

TEST(WriteDxf, DrawsOnlyTheCheckSquareOfAnEmptyPattern) {
    const test::DxfFile file(writePlainDxf(draw(Pattern{}, Marker{})));
    EXPECT_TRUE(file.faults.empty());
    EXPECT_EQ(file.polylines.size(), 1u);
}

}  // namespace
}  // namespace toile
