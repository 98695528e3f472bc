// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

using Corners = std::vector<int>;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";
const std::string kThree = "0 0 0\n1 0 0\n0 1 0\n";

PolygonSoup readPlySoup(const std::string& text) {
    return readValid(readPly, text);
}

std::string ascii(const std::string& elements, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

TEST(PlyReader, ReadsASample) {
    const PolygonSoup soup = readPlySoup(samplePlyAscii());
    ASSERT_EQ(soup.faceCount(), 3);
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2, 3}));
    EXPECT_EQ(face(soup, 2), (Corners{0, 2, 3}));
    EXPECT_EQ(soup.positions[3], Eigen::Vector3d(0, 1, -0.25));
    EXPECT_EQ(soup.uvs[2], Eigen::Vector2d(1, 1));
    EXPECT_EQ(soup.cornerUvs, soup.corners);
    EXPECT_EQ(positionText(soup, 3), "0 1e0 -0.25");
    for (const char* lineEnd : {"\r\n", "\r"}) {
        expectSameMesh(readPlySoup(withLineEnds(samplePlyAscii(), lineEnd)), soup);
    }
    const PolygonSoup binary = readPlySoup(samplePlyBinary());
    expectSameMesh(binary, soup);
    EXPECT_TRUE(binary.positionText.empty());
    EXPECT_FALSE(binary.text);
}

TEST(PlyReader, ReadsTextureCoordinatesByCorner) {
    const std::string header = "element vertex 4\n" + kXyz + "element face 3\n" +
                               "property list uchar float texcoord\n" + kList;
    const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const PolygonSoup soup = readPlySoup(ascii(header, points + "6 0 0 1 0 1 1 3 0 1 2\n"
                                                                "6 0 0 1 1 0 1 3 0 2 3\n"
                                                                "2 7 7 3 0 1 3\n"));
    EXPECT_EQ(soup.cornerUvs, (Corners{0, 1, 2, 0, 2, 3, -1, -1, -1}));
    EXPECT_EQ(soup.uvs[2], Eigen::Vector2d(1, 1));
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::IndexOutOfRange),
              "1 face without texture coordinates: their number does not fit, line 17");
    // The same vertex twice in the map: the face is on another island.
    const PolygonSoup islands = readPlySoup(ascii(header, points + "6 0 0 1 0 1 1 3 0 1 2\n"
                                                                   "6 5 5 6 6 5 6 3 0 2 3\n"
                                                                   "0 3 0 1 3\n"));
    EXPECT_EQ(islands.uvs.size(), 6U);
}

TEST(PlyReader, DividesStripsOfTriangles) {
    const std::string header =
        "element vertex 6\n" + kXyz + "element tristrips 1\nproperty list int int vertex_indices\n";
    const PolygonSoup soup = readPlySoup(
        ascii(header, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 -1 2 3 4 5\n"));
    ASSERT_EQ(soup.faceCount(), 4);
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2}));
    EXPECT_EQ(face(soup, 1), (Corners{2, 1, 3}));  // turned the same way
    EXPECT_EQ(face(soup, 2), (Corners{2, 3, 4}));
    EXPECT_EQ(face(soup, 3), (Corners{4, 3, 5}));
    // An index that is too large spoils its triangles only.
    const PolygonSoup damaged =
        readPlySoup(ascii(header, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n7 0 1 99 2 3 4 5\n"));
    ASSERT_EQ(damaged.faceCount(), 2);
    EXPECT_EQ(face(damaged, 0), (Corners{3, 2, 4}));
    EXPECT_NE(detailOf(damaged.problems, ErrorCode::IndexOutOfRange), "");
}

TEST(PlyReader, FindsTheBodyAfterAnyLineEnd) {
    const std::string bytes = samplePlyBinary();
    const std::size_t body = bytes.find("end_header\n") + 11;
    for (const char* lineEnd : {"\r\n", "\r"}) {
        const std::string header = withLineEnds(bytes.substr(0, body), lineEnd);
        expectSameMesh(readPlySoup(header + bytes.substr(body)), readPlySoup(bytes));
    }
    // After a lone CR a byte 10 is data: the least byte of the first index here.
    const std::string odd =
        "ply\rformat binary_little_endian 1.0\relement face 1\rproperty list char char "
        "vertex_index\r"
        "element vertex 11\rproperty char x\rproperty char y\rproperty char z\rend_header\r";
    EXPECT_EQ(face(readPlySoup(odd + "\n" + std::string("\0\1\2\3\4\5\6\7\10\11", 10) +
                               std::string(33, '\7')),
                   0)
                  .size(),
              10u);
}

TEST(PlyReader, ReadsBigEndianAndEveryType) {
    const std::string header =
        "ply\nformat binary_big_endian 1.0\nobj_info made by hand\nelement vertex 3\n"
        "property uint8 flag\nproperty double z\nproperty list ushort float32 weights\n"
        "property short x\nproperty float y\nelement edge 1\nproperty int vertex1\n"
        "property uint vertex2\nelement face 1\nproperty list uint8 uint16 vertex_index\n"
        "property int8 red\nend_header\n";
    const auto big = [](std::string bytes) { return std::string(bytes.rbegin(), bytes.rend()); };
    std::string body;
    for (int i = 0; i < 3; ++i) {
        body += '\1' + big(bytesOf(0.1 * i));
        body += big(bytesOf(std::int16_t{2})) + std::string(8, 'w');
        body += big(bytesOf(static_cast<std::int16_t>(-i))) +
                big(bytesOf(0.5f * static_cast<float>(i)));
    }
    body += std::string(8, 'e');
    body += '\3' + big(bytesOf(std::int16_t{2})) + big(bytesOf(std::int16_t{1})) +
            big(bytesOf(std::int16_t{0})) + 'r';
    const PolygonSoup soup = readPlySoup(header + body);
    EXPECT_EQ(soup.positions[1], Eigen::Vector3d(-1, 0.5, 0.1));
    EXPECT_EQ(soup.positions[2], Eigen::Vector3d(-2, 1, 0.1 * 2));
    EXPECT_EQ(soup.corners, (Corners{2, 1, 0}));
}

TEST(PlyReader, ConvertsFloatsExactly) {
    std::string bytes = samplePlyBinary();
    const std::size_t body = bytes.find("end_header\n") + 11;
    bytes.replace(body, 4, bytesOf(0.1f));
    EXPECT_EQ(readPlySoup(bytes).positions[0].x(), static_cast<double>(0.1f));
    EXPECT_EQ(readPlySoup(ascii("element vertex 3\n" + kXyz + "element face 1\n" + kList,
                                "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
                  .positions[0]
                  .x(),
              0.1);
}

TEST(PlyReader, ReadsAnyOrderAndSkipsTheUnknown) {
    const PolygonSoup soup = readPlySoup(
        ascii("element material 2\nproperty list int float data\nproperty uchar id\n"
              "element nothing 999999999999\n"
              "element face 2\nproperty float quality\nproperty list int uint vertex_index\n"
              "property list uchar float texcoord\n"
              "element vertex 3\nproperty float nx\nproperty float z\nproperty float x\nproperty "
              "float y\n"
              "property float texture_v\nproperty float texture_u\n"
              "element vertex 1\nproperty float x\n",
              "2 7 7 1\n0 1\n0.5 3 0 1 2 6 0 0 1 0 0 1\n0.5 3 2 1 0 0\n"
              "9 3 1 2 20 10\n9 6 4 5\n 21 11\n9 9 7 8 22 12\n5\n"));
    EXPECT_EQ(soup.positions, (std::vector<Eigen::Vector3d>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 2, 1, 0}));
    EXPECT_EQ(soup.uvs, (std::vector<Eigen::Vector2d>{{10, 20}, {11, 21}, {12, 22}}));
    EXPECT_TRUE(soup.positionText.empty() && soup.problems.empty());
}

TEST(PlyReader, KeepsTextOnlyWhereItIsOneStretch) {
    const PolygonSoup soup =
        readPlySoup(ascii("element vertex 3\n" + kXyz + "element face 1\n" + kList,
                          "0 0\n0\n 1.0\t0 0 \n0 1 0 3 0 1 2"));
    EXPECT_EQ(positionText(soup, 0), "");
    EXPECT_EQ(positionText(soup, 1), "1.0\t0 0");
    EXPECT_EQ(positionText(soup, 2), "0 1 0");
}

TEST(PlyReader, RefusesHeadersItCannotUse) {
    const std::string table[] = {
        "",
        "plx\n",
        "ply\n",
        "ply\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex 3\n",
        "ply\nformat binary 1.0\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex 99999999999999999999999\nend_header\n",
        "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float\nend_header\n",
        "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_index\nend_header\n",
        "ply\nformat ascii 1.0\nelment face 1\nend_header\n"};
    for (const std::string& text : table) {
        const Result<PolygonSoup> soup = read(readPly, text);
        ASSERT_FALSE(soup) << text;
        EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile) << text;
        EXPECT_EQ(soup.error().detail.rfind("line ", 0), 0u) << soup.error().detail;
    }
    const Result<PolygonSoup> flat =
        read(readPly, ascii("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"));
    ASSERT_FALSE(flat);
    EXPECT_NE(flat.error().detail.find("x, y and z"), std::string::npos);
}

TEST(PlyReader, TrustsNoCount) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        for (const char* count : {"2000000000", "18446744073709551615"}) {
            const std::string start = "ply\nformat " + std::string(format) + " 1.0\n";
            for (const std::string& elements :
                 {"element vertex " + std::string(count) + "\n" + kXyz,
                  "element vertex 1\n" + kXyz + "element face " + count + "\n" + kList,
                  "element x " + std::string(count) + "\nproperty list uint double y\n"}) {
                const Result<PolygonSoup> soup =
                    read(readPly, start + elements + "end_header\n" + std::string(100, '\xFF'));
                ASSERT_FALSE(soup);
                EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile);
            }
        }
    }
    const Result<PolygonSoup> longList =
        read(readPly, ascii("element vertex 3\n" + kXyz + "element face 1\n" + kList,
                            kThree + "4000000000 0 1 2\n"));
    ASSERT_FALSE(longList);
    EXPECT_EQ(longList.error().code, ErrorCode::MalformedFile);
}

TEST(PlyReader, KeepsGoingAfterBadRecords) {
    const PolygonSoup soup =
        readPlySoup(ascii("element vertex 5\n" + kXyz + "property int q\nelement face 6\n" + kList,
                          "0 0 0 a\n1 x 0 1\n0 1 0 1\n0,5 1 0 1\nnan 0 0 1\n"
                          "3 0 2 4\n3 0 1 9\n3 0 1 -1\n2 0 1\n3 0 1 b\n3 0 1 1.5\n"));
    EXPECT_EQ(soup.positions[0], Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(positionText(soup, 1), "");
    EXPECT_EQ(soup.faceCount(), 1);
    ASSERT_EQ(soup.problems.size(), 3u);
    EXPECT_EQ(soup.problems[0].code, ErrorCode::NonFinitePosition);
    EXPECT_EQ(soup.problems[0].detail,
              "1 vertex not readable, line 12; "
              "1 vertex with decimal commas; numbers need decimal points, line 14; "
              "1 vertex without finite numbers, line 15");
    EXPECT_EQ(soup.problems[1].code, ErrorCode::DegenerateFaceRecord);
    EXPECT_EQ(soup.problems[1].detail,
              "1 face left out: fewer than three corners, line 19; 1 face left out: not readable, "
              "line 20");
    EXPECT_EQ(soup.problems[2].detail,
              "3 faces left out: a corner's index is out of range, first at line 17");
}

TEST(PlyReader, RefusesAFileWithoutFaces) {
    for (const std::string& elements :
         {std::string(), "element face 0\n" + kList, std::string("element face 7\n"),
          std::string("element face 1\nproperty int id\n")}) {
        const Result<PolygonSoup> soup =
            read(readPly, ascii("element vertex 3\n" + kXyz + elements, kThree + "7\n"));
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
    }
}

}  // namespace
}  // namespace toile::test
