// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "tests/core/io/soup_checks.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::test {
namespace {

using Corners = std::vector<int>;

PolygonSoup readStlSoup(const std::string& text) {
    return readValid(readStl, text);
}

std::string binary(const std::string& header, const std::vector<std::vector<float>>& facets) {
    std::string bytes = header + std::string(80 - header.size(), ' ');
    bytes += bytesOf(static_cast<std::uint32_t>(facets.size()));
    for (const std::vector<float>& facet : facets) {
        bytes += std::string(12, '\0');
        for (const float number : facet) {
            bytes += bytesOf(number);
        }
        bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST(StlReader, MergesEqualPositionsInOrderOfAppearance) {
    const PolygonSoup ascii = readStlSoup(sampleStlAscii());
    EXPECT_EQ(ascii.positions,
              (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}, {0, 1, -0.25}}));
    EXPECT_EQ(ascii.corners, (Corners{0, 1, 2, 0, 2, 3}));
    EXPECT_TRUE(ascii.positionText.empty() && ascii.objects.empty() && ascii.problems.empty());
    expectSameMesh(readStlSoup(sampleStlBinary()), ascii);
    for (const char* lineEnd : {"\r\n", "\r", "\n\n"}) {
        expectSameMesh(readStlSoup(withLineEnds(sampleStlAscii(), lineEnd)), ascii);
    }
}

TEST(StlReader, MergesManyPositions) {
    std::vector<std::vector<float>> facets;
    for (int i = 0; i < 5000; ++i) {
        const float x = static_cast<float>(i);
        facets.push_back({x, 0, 0, x + 1, 0, 0, x, 1, 0});
    }
    const PolygonSoup soup = readStlSoup(binary("", facets));
    EXPECT_EQ(soup.faceCount(), 5000);
    EXPECT_EQ(soup.positions.size(), 10001u);
    for (int i = 1; i < 5000; ++i) {
        ASSERT_EQ(face(soup, i)[0], face(soup, i - 1)[1]);
    }
}

TEST(StlReader, TakesMinusZeroForZeroAndNothingElse) {
    const float next = std::nextafter(1.0f, 2.0f);
    const PolygonSoup soup = readStlSoup(
        binary("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {-0.0f, 0, -0.0f, next, 0, 0, 0, 1, -0.0f}}));
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 3, 2}));
    EXPECT_FALSE(std::signbit(soup.positions[0].x()));
}

TEST(StlReader, KnowsABinaryFileByItsSize) {
    const std::vector<float> facet{0, 0, 0, 1, 0, 0, 0, 1, 0};
    EXPECT_EQ(readStlSoup(binary("solid exported", {facet})).faceCount(), 1);
    EXPECT_EQ(readStlSoup(binary("exported", {facet}) + "more").faceCount(), 1);
    EXPECT_EQ(readStlSoup(binary(std::string(80, '\0'), {facet, facet})).faceCount(), 2);
}

TEST(StlReader, RefusesWhatIsNeitherKind) {
    std::string truncated = sampleStlBinary();
    truncated.resize(truncated.size() - 20);
    std::string lying = sampleStlBinary();
    lying.replace(80, 4, "\xFF\xFF\xFF\xFF");
    for (const std::string& bytes : {std::string(), std::string("so"), std::string("garbage\n"),
                                     std::string(84, 'x'), truncated, lying}) {
        const Result<PolygonSoup> soup = read(readStl, bytes);
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile);
        EXPECT_FALSE(soup.error().detail.empty());
    }
}

TEST(StlReader, ReadsLooseText) {
    const PolygonSoup soup = readStlSoup(
        "  SOLID vertex facet 1 2 3\nFACET NORMAL 0 0 1 OUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
        "VERTEX 0 1 0 ENDLOOP ENDFACET\nendsolid vertex\nsolid two\nfacet normal nan nan nan\n"
        "outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 1 endloop endfacet endsolid");
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 1, 3}));
    EXPECT_TRUE(soup.problems.empty());
}

TEST(StlReader, SaysWhenFloatsAreTooCoarseThere) {
    const auto problemsAt = [](float away) {
        const TemporaryFolder folder;
        Progress progress;
        const auto path =
            folder.write("a.stl", binary("", {{away, 0, 0, away + 8, 0, 0, away, 8, 0}}));
        auto soup = readSoup(path, progress);
        EXPECT_TRUE(soup);
        return soup ? std::move(soup->problems) : Problems();
    };
    EXPECT_TRUE(problemsAt(100).empty());
    const Problems far = problemsAt(16'000'000);
    ASSERT_EQ(far.size(), 1U);
    EXPECT_EQ(far.front().code, ErrorCode::VerticesWelded);
    const std::string said = far.front().detail;
    EXPECT_NE(said.find("far from the origin"), std::string::npos) << said;
}

TEST(StlReader, ListsBadFacets) {
    const PolygonSoup soup = readStlSoup(
        "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendloop\nfacet\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1\nendloop\nfacet\nvertex 0 0 0\nfacet\nvertex nan 0 0\nvertex 1 0 0\n"
        "vertex nan 0 0\nendloop\nvertex 1 1 1");
    EXPECT_EQ(soup.faceCount(), 2);
    ASSERT_EQ(soup.problems.size(), 2u);
    EXPECT_EQ(soup.problems[0].detail,
              "1 face left out: fewer than three corners, line 5; "
              "2 faces left out: not readable, first at line 13");
    EXPECT_EQ(soup.problems[1].code, ErrorCode::NonFinitePosition);
    EXPECT_EQ(soup.problems[1].detail,
              "1 vertex not readable, line 9; 1 vertex without finite numbers, line 14");
}

TEST(StlReader, NotesNonFiniteBinaryPositions) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const PolygonSoup soup =
        readStlSoup(binary("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, nan, 1, 0}}));
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::NonFinitePosition),
              "1 vertex without finite numbers, facet 2");
}

TEST(StlReader, RefusesAFileWithoutFaces) {
    for (const std::string& bytes : {std::string("solid a\nendsolid a\n"), binary("", {})}) {
        const Result<PolygonSoup> soup = read(readStl, bytes);
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
    }
}

}  // namespace
}  // namespace toile::test
