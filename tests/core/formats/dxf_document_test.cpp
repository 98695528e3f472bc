// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_document.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr std::string_view kSmall =
    "0\r\nSECTION\r\n2\r\nBLOCKS\r\n"
    "  0\r\nBLOCK\r\n  8\r\n1\r\n  2\r\nfront\r\n 10\r\n1.5\r\n 20\r\n-2\r\n"
    "  0\r\nPOLYLINE\r\n  8\r\n14\r\n 66\r\n1\r\n 70\r\n1\r\n"
    "  0\r\nVERTEX\r\n 10\r\n0\r\n 20\r\n0\r\n  0\r\nVERTEX\r\n 10\r\n1e1\r\n 20\r\n0\r\n"
    "  0\r\nVERTEX\r\n 10\r\nnan\r\n 20\r\n0\r\n  0\r\nVERTEX\r\n 10\r\n+3\r\n 20\r\n4.25\r\n"
    "  0\r\nSEQEND\r\n  0\r\nPOINT\r\n  8\r\n4\r\n 10\r\n5\r\n 20\r\n0\r\n 30\r\n3\r\n 50\r\n90\r\n"
    "  0\r\nENDBLK\r\n  0\r\nENDSEC\r\n"
    "  0\r\nSECTION\r\n  2\r\nENTITIES\r\n  0\r\nTEXT\r\n  8\r\n1\r\n  1\r\nUnits: METRIC \r\n"
    "  0\r\nLWPOLYLINE\r\n 70\r\n0\r\n 10\r\n1\r\n 20\r\n2\r\n 10\r\n3\r\n 20\r\n4\r\n"
    "  0\r\nENDSEC\r\n  0\r\nEOF\r\n";

TEST(DxfDocument, HoldsBlocksEntitiesAndTheirGroups) {
    const auto document = readDxfDocument(kSmall);
    ASSERT_TRUE(document) << sentence(document.error());
    ASSERT_EQ(document->blocks.size(), 1U);
    const DxfBlock& block = document->blocks.front();
    EXPECT_EQ(block.name, "front");
    EXPECT_EQ(block.base, Eigen::Vector2d(1.5, -2));
    ASSERT_EQ(block.entities.size(), 2U);
    EXPECT_EQ(block.entities[0].layer, "14");
    EXPECT_TRUE(block.entities[0].closed);
    const Points2 triangle = (Points2(3, 2) << 0, 0, 10, 0, 3, 4.25).finished();
    EXPECT_EQ(block.entities[0].points, triangle);
    EXPECT_EQ(block.entities[1].number(50), 90);
    EXPECT_EQ(block.entities[1].point(), Eigen::Vector2d(5, 0));
    ASSERT_EQ(document->entities.size(), 2U);
    EXPECT_EQ(document->entities[0].text(1), "Units: METRIC");
    EXPECT_EQ(document->entities[1].points, (Points2(2, 2) << 1, 2, 3, 4).finished());
    EXPECT_FALSE(document->entities[1].closed);
}

TEST(DxfDocument, RefusesDecimalCommas) {
    std::string commas(kSmall);
    commas.replace(commas.find("4.25"), 4, "4,25");
    const auto document = readDxfDocument(commas);
    ASSERT_FALSE(document);
    EXPECT_NE(sentence(document.error()).find("\"4,25\""), std::string::npos)
        << sentence(document.error());
}

TEST(DxfDocument, TakesEitherEndOfLine) {
    std::string unix(kSmall);
    std::erase(unix, '\r');
    const auto document = readDxfDocument(unix);
    ASSERT_TRUE(document);
    EXPECT_EQ(document->blocks.front().entities.front().points.rows(), 3);
}

TEST(DxfDocument, ReadsWhatTheWriterWrites) {
    const std::string bytes = writePlainDxf(test::sewingDrawing());
    const auto document = readDxfDocument(bytes);
    ASSERT_TRUE(document);
    EXPECT_EQ(document->header.at("$INSUNITS").front().value, "4");
    EXPECT_EQ(document->layers.at("CUT"), 1);
    EXPECT_EQ(std::ranges::count(document->entities, "POLYLINE", &DxfEntity::kind), 5);
}

TEST(DxfDocument, RefusesWhatIsNone) {
    for (const std::string_view bytes :
         {"", "AutoCAD Binary DXF\r\n\x1a", "hello", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n",
          "0\nSECTION\nx\ny\n"}) {
        const auto document = readDxfDocument(bytes);
        ASSERT_FALSE(document) << bytes;
        EXPECT_EQ(document.error().code, ErrorCode::MalformedFile);
    }
}

TEST(DxfDocument, SurvivesWhateverIsCutOffOrChanged) {
    for (std::size_t length = 0; length < kSmall.size(); ++length) {
        std::string bytes(kSmall.substr(0, length));
        (void)readDxfDocument(bytes);
        bytes = kSmall;
        bytes[length] = static_cast<char>(bytes[length] + 1);
        (void)readDxfDocument(bytes);
    }
}

TEST(DxfDocument, ReadsThePatternsOfOtherPrograms) {
    const struct {
        const char* name;
        std::size_t blocks;
    } files[] = {{"clo-box", 1},        {"clo-pattern", 9},    {"men_classic_tee_aama", 105},
                 {"graded_a_aama", 42}, {"graded_a_astm", 42}, {"with_sewline_aama", 56},
                 {"skirt_clo", 4}};
    for (const auto& [name, blocks] : files) {
        const auto path = test::dataFile("patterns/" + std::string(name) + ".dxf");
        TOILE_NEEDS_SHARED(path);
        const auto bytes = readFile(path);
        ASSERT_TRUE(bytes);
        const auto document = readDxfDocument(*bytes);
        ASSERT_TRUE(document) << name << ": " << sentence(document.error());
        EXPECT_EQ(document->blocks.size(), blocks) << name;
        for (const DxfBlock& block : document->blocks) {
            EXPECT_FALSE(block.entities.empty()) << name << ' ' << block.name;
        }
    }
}

TEST(DxfDocument, EndsAPolylineWhereAnotherSectionBegins) {
    const std::string polyline =
        "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\n1\n0\nVERTEX\n10\n1\n20\n2\n";
    for (const char* rest : {"", "0\nEOF\n", "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nLINE\n",
                             "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n"}) {
        const std::string bytes = polyline + rest;
        const auto document = readDxfDocument(bytes);
        ASSERT_TRUE(document) << rest;
        EXPECT_EQ(document->entities.front().points.rows(), 1) << rest;
    }
}

}  // namespace
}  // namespace toile
