// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/dxf_drawing.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/base/units.h"
#include "core/formats/dxf/dxf_document.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr std::string_view kOnePiece =
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n"
    "0\nBLOCK\n2\nFRONT\n0\nTEXT\n8\n1\n1\nPIECE NAME: Front one \n0\nTEXT\n8\n1\n1\n# 12\n"
    "0\nPOLYLINE\n8\n1\n70\n1\n0\nVERTEX\n10\n1\n20\n0\n0\nVERTEX\n10\n2\n20\n0\n0\nSEQEND\n"
    "0\nLINE\n8\n7\n10\n0\n20\n0\n11\n0\n21\n10\n0\nPOINT\n8\n4\n10\n1\n20\n0\n30\n0.25\n50\n90\n"
    "0\nPOINT\n8\n4\n10\nx\n20\n0\n0\nENDBLK\n0\nENDSEC\n"
    "0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nFRONT\n10\n0\n20\n1\n0\nENDSEC\n0\nEOF\n";

TEST(DxfDrawingReader, HoldsLinesRecordsAndTextsInMillimetres) {
    const auto document = readDxfDocument(kOnePiece);
    ASSERT_TRUE(document);
    EXPECT_TRUE(document->hasEnd);
    EXPECT_EQ(headerUnit(*document), LengthUnit::Inch);
    const DxfDrawing read = dxfDrawing(*document, 25.4);
    ASSERT_EQ(read.blocks.size(), 1U);
    const DxfGroupOfEntities& block = read.blocks.front();
    EXPECT_EQ(block.name, "FRONT");
    ASSERT_EQ(block.polylines.size(), 1U);
    EXPECT_EQ(block.polylines[0].points, (Points2(2, 2) << 25.4, 0, 50.8, 0).finished());
    EXPECT_TRUE(block.polylines[0].closed);
    ASSERT_EQ(block.lines.size(), 1U);
    EXPECT_EQ(block.lines[0].points, (Points2(2, 2) << 0, 0, 0, 254).finished());
    ASSERT_EQ(block.records.size(), 1U);
    EXPECT_EQ(block.records[0].height, 0.25 * 25.4);
    EXPECT_EQ(block.records[0].width, std::nullopt);
    EXPECT_DOUBLE_EQ(*block.records[0].angle, kPi / 2);
    EXPECT_EQ(block.texts.size(), 2U);
    EXPECT_EQ(block.said.at("piece name"), "Front one");
    ASSERT_EQ(read.page.inserts.size(), 1U);
    EXPECT_EQ(read.page.inserts[0].second, Eigen::Vector2d(0, 25.4));
}

TEST(DxfDrawingReader, ReadsThePiecesOfOtherPrograms) {
    for (const char* name : {"clo-pattern", "graded_a_astm", "with_sewline_aama", "skirt_clo"}) {
        const auto path = test::dataFile("patterns/" + std::string(name) + ".dxf");
        TOILE_NEEDS_SHARED(path);
        const auto bytes = readFile(path);
        ASSERT_TRUE(bytes);
        const auto document = readDxfDocument(*bytes);
        ASSERT_TRUE(document);
        const DxfDrawing read = dxfDrawing(*document, 1);
        EXPECT_EQ(read.page.inserts.size(), read.blocks.size()) << name;
        EXPECT_TRUE(read.page.said.contains("units")) << name;
        for (const DxfGroupOfEntities& block : read.blocks) {
            EXPECT_TRUE(block.said.contains("piece name")) << name << ' ' << block.name;
            EXPECT_TRUE(std::ranges::any_of(block.polylines,
                                            [](const DxfLine& line) { return line.layer == "1"; }))
                << name << ' ' << block.name;
        }
    }
}

}  // namespace
}  // namespace toile
