// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

using Corners = std::vector<int>;

PolygonSoup readOffSoup(const std::string& text) {
    return readValid(readOff, text);
}

TEST(OffReader, ReadsASample) {
    const PolygonSoup soup = readOffSoup(sampleOff());
    ASSERT_EQ(soup.faceCount(), 3);
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2, 3}));
    EXPECT_EQ(face(soup, 2), (Corners{0, 2, 3}));
    EXPECT_EQ(soup.positions[3], Eigen::Vector3d(0, 1, -0.25));
    EXPECT_EQ(positionText(soup, 1), "1.5 0 0");
    EXPECT_EQ(positionText(soup, 3), "0 1e0 -0.25");
    EXPECT_TRUE(soup.problems.empty() && soup.uvs.empty() && soup.cornerUvs.empty());
    for (const char* lineEnd : {"\r\n", "\r", "\n\n", "\n# note\n"}) {
        expectSameMesh(readOffSoup(withLineEnds(sampleOff(), lineEnd)), soup);
    }
}

TEST(OffReader, ReadsVariantsOfTheHeader) {
    const std::string faces = "3 0 1 2\n";
    const std::string table[] = {
        "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n",
        "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n",
        "# first\nOFF # yes\n# counts\n 3 1 0 # so\n0 0 0\n1 0 0\n0 1 0\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n",
        "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 9 0 0\n1 0 0 0 0 1\n0 1 0 0 0 1\n",
    };
    for (const std::string& text : table) {
        const PolygonSoup soup = readOffSoup(text + faces);
        ASSERT_EQ(soup.faceCount(), 1) << text;
        EXPECT_EQ(soup.positions, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        EXPECT_TRUE(soup.problems.empty()) << text;
    }
}

TEST(OffReader, RefusesHeadersItCannotUse) {
    for (const char* text :
         {"", "OFX\n3 1 0\n", "4OFF\n3 1 0\n", "nOFF\n3\n3 1 0\n", "OFF BINARY\n", "OFF\n",
          "OFF\n3\n", "OFF\n-3 1 0\n", "OFF\nx y z\n", "OFF\n3.5 1 0\n", "OFF 99999999999 1 0\n"}) {
        const Result<PolygonSoup> soup = read(readOff, text);
        ASSERT_FALSE(soup) << text;
        EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile) << text;
        EXPECT_EQ(soup.error().detail.rfind("line ", 0), 0u) << soup.error().detail;
    }
}

TEST(OffReader, TrustsNoCount) {
    for (const char* counts : {"2000000000 1 0", "3 2000000000 0", "2147483647 2147483647 0"}) {
        const Result<PolygonSoup> soup =
            read(readOff, "OFF\n" + std::string(counts) + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile);
    }
    const PolygonSoup soup =
        readOffSoup("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n-5 0 1 2\n3 0 1 2\n");
    EXPECT_EQ(soup.faceCount(), 1);
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::DegenerateFaceRecord),
              "2 faces left out: not readable, first at line 6");
}

TEST(OffReader, RefusesATruncatedFile) {
    const Result<PolygonSoup> soup = read(readOff, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\n");
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile);
    EXPECT_EQ(soup.error().detail,
              "the header promises 3 vertices and 2 faces, but the file ends after 3 vertices and "
              "1 face");
}

TEST(OffReader, KeepsGoingAfterBadRecords) {
    const PolygonSoup soup = readOffSoup(
        "OFF\n4 5 0\n0 0 0\n1 0\n0 1 0\n0,5 1 0\n3 0 1 2\n3 0 1 4\n2 0 1\n3 0 1\n3 0 -1 2\n");
    EXPECT_EQ(soup.positions.size(), 4u);
    EXPECT_TRUE(soup.positions[1].hasNaN() && soup.positions[3].hasNaN());
    EXPECT_EQ(positionText(soup, 1), "");
    EXPECT_EQ(soup.faceCount(), 1);
    ASSERT_EQ(soup.problems.size(), 3u);
    EXPECT_EQ(soup.problems[0].detail,
              "1 vertex not readable, line 4; "
              "1 vertex with decimal commas; numbers need decimal points, line 6");
    EXPECT_EQ(soup.problems[1].code, ErrorCode::DegenerateFaceRecord);
    EXPECT_EQ(soup.problems[2].code, ErrorCode::IndexOutOfRange);
    EXPECT_EQ(soup.problems[2].detail,
              "2 faces left out: a corner's index is out of range, first at line 8");
}

TEST(OffReader, RefusesAFileWithoutFaces) {
    const Result<PolygonSoup> soup = read(readOff, "OFF\n1 0 0\n0 0 0\n");
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
    EXPECT_EQ(soup.error().detail, "1 vertex, no faces");
}

}  // namespace
}  // namespace toile::test
