// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/io/soup_checks.h"

#include <bit>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/core/io/soup_promises.h"

namespace toile::test {

Result<PolygonSoup> read(ReadFunction reader, std::string bytes) {
    Progress progress;
    return reader(std::make_shared<const std::string>(std::move(bytes)), "test", progress);
}

PolygonSoup readValid(ReadFunction reader, const std::string& bytes) {
    const Result<PolygonSoup> soup = read(reader, bytes);
    EXPECT_TRUE(soup) << (soup ? "" : soup.error().detail);
    if (!soup) {
        return {};
    }
    expectValid(*soup);
    return *soup;
}

void expectValid(const PolygonSoup& soup) {
    EXPECT_EQ(brokenPromise(soup), "");
}

std::vector<int> face(const PolygonSoup& soup, int index) {
    return {soup.corners.begin() + soup.faceStart[index],
            soup.corners.begin() + soup.faceStart[index + 1]};
}

std::string_view positionText(const PolygonSoup& soup, int index) {
    const TextSpan span = soup.positionText.at(static_cast<std::size_t>(index));
    return std::string_view(*soup.text).substr(span.offset, span.length);
}

void expectSameMesh(const PolygonSoup& a, const PolygonSoup& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.uvs, b.uvs);
    EXPECT_EQ(a.faceStart, b.faceStart);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.cornerUvs, b.cornerUvs);
    EXPECT_EQ(a.faceObject, b.faceObject);
    EXPECT_EQ(a.objects, b.objects);
    EXPECT_EQ(a.faceGroup, b.faceGroup);
    EXPECT_EQ(a.groups, b.groups);
    EXPECT_EQ(a.faceMaterial, b.faceMaterial);
    EXPECT_EQ(a.materials, b.materials);
    EXPECT_EQ(a.problems.size(), b.problems.size());
}

std::string detailOf(const Problems& problems, ErrorCode code) {
    if (problems.size() != 1 || problems.front().code != code) {
        ADD_FAILURE() << "expected the one problem " << name(code) << ", found " << problems.size();
        return "";
    }
    EXPECT_EQ(problems.front().subject.name, "test");
    return problems.front().detail;
}

std::string sampleObj() {
    return "# a sample\nmtllib missing.mtl\no front\nv 0 0 0\nv 1.5 0 0 0.5 0.5 0.5\nv 1.5 1 0\n"
           "v 0 1e0 -0.25\nvt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\nvn 0 0 1\ng a b\nusemtl cloth\n"
           "f 1/1/1 2/2/1 3/3/1 4/4/1\ng f 1 2 3\nl 1 2\np 1\nf -4//-1 -3//-1 \\\n -2//-1\no back\n"
           "f 1 3 4\n";
}

std::string sampleOff() {
    return "# a sample\nOFF\n4 3 0\n0 0 0\n1.5 0 0 # corner\n\n1.5 1 0\n0 1e0 -0.25\n"
           "4 0 1 2 3\n3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5\n";
}

std::string samplePlyAscii() {
    return "ply\nformat ascii 1.0\ncomment a sample\nelement vertex 4\nproperty float x\n"
           "property float y\nproperty float z\nproperty float s\nproperty float t\n"
           "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 0 0\n1.5 0 0 1 0\n1.5 1 0 1 1\n0 1e0 -0.25 0 1\n4 0 1 2 3\n3 0 1 2\n3 0 2 3\n";
}

std::string samplePlyBinary() {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nproperty float s\nproperty float t\n"
        "element face 3\nproperty list uchar int vertex_indices\nend_header\n";
    for (const float number : {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.5f, 0.0f, 0.0f,   1.0f, 0.0f,
                               1.5f, 1.0f, 0.0f, 1.0f, 1.0f, 0.0f, 1.0f, -0.25f, 0.0f, 1.0f}) {
        bytes += bytesOf(number);
    }
    for (const std::vector<int>& corners : {std::vector<int>{0, 1, 2, 3}, {0, 1, 2}, {0, 2, 3}}) {
        bytes += static_cast<char>(corners.size());
        for (const int corner : corners) {
            bytes += bytesOf(corner);
        }
    }
    return bytes;
}

std::string sampleStlAscii() {
    return "solid front\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1.5 0 0\n"
           "   vertex 1.5 1 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n"
           "   vertex 0 0 0\n   vertex 1.5 1 0\n   vertex 0 1e0 -0.25\n  endloop\n endfacet\n"
           "endsolid front\n";
}

std::string sampleStlBinary() {
    std::string bytes(80, ' ');
    bytes += bytesOf(std::uint32_t{2});
    for (const std::vector<float>& facet :
         {std::vector<float>{0, 0, 1, 0, 0, 0, 1.5f, 0, 0, 1.5f, 1, 0},
          {0, 0, 1, 0, 0, 0, 1.5f, 1, 0, 0, 1, -0.25f}}) {
        for (const float number : facet) {
            bytes += bytesOf(number);
        }
        bytes += std::string(2, '\0');
    }
    return bytes;
}

std::string withLineEnds(std::string_view text, std::string_view lineEnd) {
    std::string out;
    for (const char c : text) {
        out += c == '\n' ? std::string(lineEnd) : std::string(1, c);
    }
    return out;
}

template <class T>
std::string bytesOf(T value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return std::endian::native == std::endian::little ? bytes
                                                      : std::string(bytes.rbegin(), bytes.rend());
}

template std::string bytesOf(int);
template std::string bytesOf(std::uint32_t);
template std::string bytesOf(std::int16_t);
template std::string bytesOf(float);
template std::string bytesOf(double);

}  // namespace toile::test
