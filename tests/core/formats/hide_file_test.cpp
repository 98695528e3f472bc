// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hide_file.h"

#include <gtest/gtest.h>

#include "core/geometry/polygon.h"

namespace toile {
namespace {

constexpr const char* kHideSvg =
    "<svg xmlns='http://www.w3.org/2000/svg' width='900mm' height='800mm' viewBox='0 0 900 800'>"
    "<g id='grade 2'><rect x='600' y='100' width='100' height='200'/></g>"
    "<g id='edge'><path d='M50 50L850 80L800 750L100 700Z'/></g>"
    "<g id='hole'><path d='M200 200L300 200L300 300Z'/><path d='M870 10L890 10L890 "
    "30Z'/></g></svg>";

/// A closed polyline of a DXF file.
std::string dxfRing(const std::string& layer, const std::vector<std::pair<int, int>>& points) {
    std::string text = "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n70\n1\n";
    for (const auto& [x, y] : points) {
        text += "0\nVERTEX\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n" +
                std::to_string(y) + "\n";
    }
    return text + "0\nSEQEND\n";
}

TEST(HideFile, TheLargestLineIsItsEdgeAndLayersNameGrades) {
    const auto read = readHide(kHideSvg, PatternFileKind::Svg);
    ASSERT_TRUE(read) << sentence(read.error());
    const Hide& hide = read->hide;
    EXPECT_NEAR(hide.outline.minCoeff(), 0, 1e-9);
    EXPECT_NEAR(hide.outline.col(0).maxCoeff(), 800, 1e-6);
    ASSERT_EQ(hide.zones.size(), 2U);
    EXPECT_EQ(hide.zones[0].grade, 2);
    EXPECT_NEAR(geometry::signedAreaOf(hide.zones[0].outline), 20000, 1e-3);
    EXPECT_EQ(hide.zones[1].grade, 0);
    ASSERT_EQ(read->notes.size(), 1U);
    EXPECT_NE(read->notes[0].find("(layer \"hole\")"), std::string::npos);
}

TEST(HideFile, IsReadFromDxfToo) {
    const std::string dxf =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\n"
        "ENTITIES\n" +
        dxfRing("EDGE", {{10, 10}, {1010, 10}, {1010, 810}, {10, 810}}) +
        dxfRing("Grade_3", {{100, 100}, {200, 100}, {200, 300}}) + "0\nENDSEC\n0\nEOF\n";
    const auto read = readHide(dxf, PatternFileKind::Dxf);
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_NEAR(geometry::signedAreaOf(read->hide.outline), 800'000, 1e-3);
    ASSERT_EQ(read->hide.zones.size(), 1U);
    EXPECT_EQ(read->hide.zones[0].grade, 3);
    EXPECT_NEAR(read->hide.zones[0].outline.col(0).minCoeff(), 90, 1e-6);
}

TEST(HideFile, HolesMayBeRound) {
    const std::string dxf =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n"
        "0\nBLOCK\n2\nhole\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n0\nENDBLK\n0\nENDSEC\n"
        "0\nSECTION\n2\nENTITIES\n" +
        dxfRing("edge", {{0, 0}, {1000, 0}, {1000, 800}, {0, 800}}) +
        "0\nCIRCLE\n8\nhole\n10\n300\n20\n300\n40\n100\n"
        "0\nINSERT\n2\nhole\n8\nhole\n10\n700\n20\n300\n41\n50\n42\n-50\n"
        "0\nLINE\n8\nhole\n10\n1\n20\n1\n11\n2\n21\n2\n0\nHATCH\n8\n0\n0\nENDSEC\n0\nEOF\n";
    const auto read = readHide(dxf, PatternFileKind::Dxf);
    ASSERT_TRUE(read) << sentence(read.error());
    ASSERT_EQ(read->hide.zones.size(), 2U);
    EXPECT_NEAR(geometry::perimeterOf(read->hide.zones[0].outline), 200 * 3.14159265, 0.05);
    EXPECT_NEAR(geometry::perimeterOf(read->hide.zones[1].outline), 100 * 3.14159265, 0.05);
    EXPECT_NEAR(read->hide.zones[1].outline.col(0).mean(), 700, 1e-6);
    ASSERT_EQ(read->notes.size(), 2U);
    EXPECT_NE(read->notes[0].find("1 HATCH"), std::string::npos);
    EXPECT_NE(read->notes[1].find("1 line"), std::string::npos);
}

TEST(HideFile, SaysWhatIsWrong) {
    const auto empty = readHide("<svg xmlns='http://www.w3.org/2000/svg'/>", PatternFileKind::Svg);
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().code, ErrorCode::NoGeometry);
    EXPECT_EQ(readHide("hide.obj").error().code, ErrorCode::UnknownFormat);
    EXPECT_EQ(readHide("none.svg").error().code, ErrorCode::FileUnreadable);
}

TEST(HideFile, GradesAreNumbersAfterTheWord) {
    EXPECT_EQ(gradeOfLayer("grade 2"), 2);
    EXPECT_EQ(gradeOfLayer("GRADE-12"), 12);
    EXPECT_EQ(gradeOfLayer("grade"), 0);
    EXPECT_EQ(gradeOfLayer("2"), 0);
}

TEST(HideFile, LinesThatCrossThemselvesAreRefused) {
    EXPECT_FALSE(
        readHide("<svg xmlns='http://www.w3.org/2000/svg' width='900mm' height='800mm' "
                 "viewBox='0 0 900 800'><path d='M0 0L800 700L800 0L100 300Z'/></svg>",
                 PatternFileKind::Svg));
}

}  // namespace
}  // namespace toile
