// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

using Corners = std::vector<int>;

const std::string kThreePoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

PolygonSoup readObjSoup(const std::string& text) {
    return readValid(readObj, text);
}

TEST(ObjReader, ReadsEveryFormOfCorner) {
    const std::string points = kThreePoints + "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
    const std::pair<const char*, bool> table[] = {{"f 1 2 3", false},
                                                  {"f 1/3 2/2 3/1", true},
                                                  {"f 1//1 2//1 3//1", false},
                                                  {"f 1/3/1 2/2/1 3/1/1", true},
                                                  {"f 1// 2// 3//", false},
                                                  {"f 1/ 2/ 3/", false},
                                                  {"f -3/-1 -2/-2 -1/-3", true},
                                                  {"f +1/+3/ +2/2/ 3/1/", true}};
    for (const auto& [line, hasUvs] : table) {
        const PolygonSoup soup = readObjSoup(points + line);
        ASSERT_EQ(soup.faceCount(), 1) << line;
        EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2})) << line;
        EXPECT_EQ(soup.cornerUvs, (hasUvs ? Corners{2, 1, 0} : Corners{-1, -1, -1})) << line;
        EXPECT_TRUE(soup.problems.empty()) << line;
    }
}

TEST(ObjReader, KeepsPolygonsAndMixedUvs) {
    const PolygonSoup soup =
        readObjSoup(kThreePoints + "v 0 0 1\nv 1 1 1\nvt 0.5 0.25 7\nf 1 2/1 3 4 5\nf 1 2 3");
    EXPECT_EQ(soup.faceCount(), 2);
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2, 3, 4}));
    EXPECT_EQ(soup.cornerUvs, (Corners{-1, 0, -1, -1, -1, -1, -1, -1}));
    EXPECT_EQ(soup.uvs, (std::vector<Eigen::Vector2d>{{0.5, 0.25}}));
}

TEST(ObjReader, CountsNegativeIndicesFromTheirLine) {
    const PolygonSoup soup = readObjSoup(kThreePoints + "f -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n");
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2}));
    EXPECT_EQ(face(soup, 1), (Corners{1, 2, 3}));
}

TEST(ObjReader, AllowsFacesBeforeTheirVertices) {
    const PolygonSoup soup =
        readObjSoup("f 1/1 2/2 3/3\n" + kThreePoints + "vt 0 0\nvt 1 0\nvt 0 1\n");
    EXPECT_EQ(face(soup, 0), (Corners{0, 1, 2}));
    EXPECT_EQ(soup.cornerUvs, (Corners{0, 1, 2}));
    EXPECT_TRUE(soup.problems.empty());
}

TEST(ObjReader, KeepsNamesPerFace) {
    const PolygonSoup soup = readObjSoup(kThreePoints +
                                         "f 1 2 3\no  Front left \nf 1 2 3\ng f 1 2 3\nf 2 3 1\n"
                                         "o Back # 2\nusemtl red\nf 3 1 2\no Front left\nf 1 2 3\n"
                                         "g\nf 1 2 3\n");
    EXPECT_EQ(soup.faceCount(), 6);
    EXPECT_EQ(soup.objects, (std::vector<std::string>{"Front left", "Back # 2"}));
    EXPECT_EQ(soup.faceObject, (Corners{-1, 0, 0, 1, 0, 0}));
    EXPECT_EQ(soup.groups, (std::vector<std::string>{"f 1 2 3"}));
    EXPECT_EQ(soup.faceGroup, (Corners{-1, -1, 0, 0, 0, -1}));
    EXPECT_EQ(soup.materials, (std::vector<std::string>{"red"}));
    EXPECT_EQ(soup.faceMaterial, (Corners{-1, -1, -1, 0, 0, 0}));
}

TEST(ObjReader, HasNoNamesWhereTheFileHasNone) {
    const PolygonSoup soup = readObjSoup(kThreePoints + "g\nf 1 2 3\n");
    EXPECT_TRUE(soup.objects.empty() && soup.groups.empty() && soup.materials.empty());
    EXPECT_TRUE(soup.faceObject.empty() && soup.faceGroup.empty() && soup.faceMaterial.empty());
}

TEST(ObjReader, MakesNamesReadable) {
    const PolygonSoup soup = readObjSoup(kThreePoints +
                                         "o R\xFC"
                                         "cken\nf 1 2 3\no R\xC3\xBC"
                                         "cken\nf 1 2 3\n"
                                         "o a\tb\x01\nf 1 2 3\no \xED\xA0\x80\nf 1 2 3\n");
    EXPECT_EQ(soup.objects, (std::vector<std::string>{"R\xC3\xBC"
                                                      "cken",
                                                      "a b ", "\xC3\xAD\xC2\xA0 "}));
    EXPECT_EQ(soup.faceObject, (Corners{0, 0, 1, 2}));
}

TEST(ObjReader, ReadsAnyLineEnd) {
    const PolygonSoup expected = readObjSoup(sampleObj());
    EXPECT_EQ(expected.faceCount(), 3);
    for (const char* lineEnd : {"\r\n", "\r"}) {
        expectSameMesh(readObjSoup(withLineEnds(sampleObj(), lineEnd)), expected);
    }
    expectSameMesh(readObjSoup("\xEF\xBB\xBF" + sampleObj()), expected);
    std::string unended = sampleObj();
    unended.pop_back();
    expectSameMesh(readObjSoup(unended), expected);
    expectSameMesh(readObjSoup("  \t" + withLineEnds(sampleObj(), "\n \t")), expected);
}

TEST(ObjReader, JoinsLinesAtABackslash) {
    const PolygonSoup soup = readObjSoup(
        "v 1 \\\n2\\\r\n 3\nv 4 5 6 \\\n7\nv 0 0 0\nf 1 \\\n\\\n 2 3\nvt 1 \\\n 2\n"
        "# a path C:\\\nv 7 7 7\ng D:\\\nf 1 2 4\nf 1 2 3 \\");
    ASSERT_EQ(soup.positions.size(), 4u);
    EXPECT_EQ(soup.positions[0], Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(soup.uvs[0], Eigen::Vector2d(1, 2));
    EXPECT_EQ(positionText(soup, 0), "");
    EXPECT_EQ(positionText(soup, 1), "");
    EXPECT_EQ(positionText(soup, 3), "7 7 7");
    EXPECT_EQ(soup.groups, (std::vector<std::string>{"D:\\"}));
}

TEST(ObjReader, ReadsNumbersAsWritten) {
    const double inf = std::numeric_limits<double>::infinity();
    const std::pair<const char*, double> table[] = {
        {"1", 1},
        {"+1.5", 1.5},
        {"-.5", -0.5},
        {"5.", 5},
        {"1e3", 1000},
        {"1E-3", 0.001},
        {"+1.5e+2", 150},
        {"0.1", 0.1},
        {"inf", inf},
        {"-inf", -inf},
        {"Infinity", inf},
        {"1e999", inf},
        {"-1e999", -inf},
        {"1e-999", 0},
        {"0.30000000000000004", 0.30000000000000004},
        {"5e-324", 5e-324},
        {"1.7976931348623157e308", std::numeric_limits<double>::max()}};
    for (const auto& [text, value] : table) {
        const PolygonSoup soup =
            readObjSoup("v " + std::string(text) + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
        ASSERT_FALSE(soup.positions.empty()) << text;
        EXPECT_EQ(soup.positions[0].x(), value) << text;
        EXPECT_EQ(soup.problems.empty(), std::isfinite(value)) << text;
    }
    for (const char* text : {"nan", "-nan", "NaN", "nan(ind)", "-nan(ind)"}) {
        const PolygonSoup soup = readObjSoup(kThreePoints + "v 0 " + text + " 0\nf 1 2 3");
        EXPECT_TRUE(std::isnan(soup.positions[3].y())) << text;
        EXPECT_EQ(detailOf(soup.problems, ErrorCode::NonFinitePosition),
                  "1 vertex without finite numbers, line 4");
        EXPECT_EQ(positionText(soup, 3), "0 " + std::string(text) + " 0");
    }
}

TEST(ObjReader, KeepsThePlaceOfAVertexThatCannotBeRead) {
    for (const char* line : {"v", "v 1", "v 1 2", "v 1 2 x", "v 1 2 3x", "v 0x1 2 3", "v +-1 2 3",
                             "v 1.#QNAN 1.#QNAN 1.#QNAN", "v # 1 2 3", "v 1 2 3,", "v 1d0 2 3"}) {
        const PolygonSoup soup =
            readObjSoup(std::string(line) + "\n" + kThreePoints + line + "\nf 2 3 4\n");
        ASSERT_EQ(soup.positions.size(), 5u) << line;
        EXPECT_TRUE(soup.positions[0].hasNaN()) << line;
        EXPECT_EQ(soup.positions[2], Eigen::Vector3d(1, 0, 0)) << line;
        EXPECT_EQ(positionText(soup, 0), "") << line;
        EXPECT_EQ(positionText(soup, 2), "1 0 0") << line;
        EXPECT_EQ(detailOf(soup.problems, ErrorCode::NonFinitePosition),
                  "2 vertices not readable, first at line 1")
            << line;
    }
}

TEST(ObjReader, HintsAtDecimalCommas) {
    const PolygonSoup soup = readObjSoup(kThreePoints + "v 0,5 1,25 2\nf 1 2 3\n");
    EXPECT_EQ(soup.positions.size(), 4u);
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::NonFinitePosition),
              "1 vertex with decimal commas; numbers need decimal points, line 4");
}

TEST(ObjReader, LeavesOutFacesWithIndicesOutOfRange) {
    for (const char* bad : {"4", "0", "-4", "99999999999999999999", "-99999999999999999999",
                            "2147483647", "-2147483648", "2147483648"}) {
        const PolygonSoup soup = readObjSoup(kThreePoints + "o a\nf 1 2 3\no b\nf 1 2 " + bad +
                                             "\nf " + bad + " 2 3 1\no c\nf 3 1 2\n");
        ASSERT_EQ(soup.faceCount(), 2) << bad;
        EXPECT_EQ(face(soup, 1), (Corners{2, 0, 1})) << bad;
        EXPECT_EQ(soup.faceObject, (Corners{0, 2})) << bad;
        EXPECT_EQ(detailOf(soup.problems, ErrorCode::IndexOutOfRange),
                  "2 faces left out: a corner's index is out of range, first at line 7");
    }
}

TEST(ObjReader, DropsUvsOutOfRange) {
    const PolygonSoup soup = readObjSoup(kThreePoints + "vt 0 0\nf 1/1 2/2 3/0\nf 1/-2 2/-1 3/1\n");
    EXPECT_EQ(soup.faceCount(), 2);
    EXPECT_EQ(soup.cornerUvs, (Corners{0, -1, -1, -1, 0, 0}));
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::IndexOutOfRange),
              "3 corners without texture coordinate: its index is out of range, first at line 5");
    EXPECT_TRUE(readObjSoup(kThreePoints + "f 1/1 2/2 3/3\n").cornerUvs.empty());
}

TEST(ObjReader, ListsFacesThatAreNone) {
    const PolygonSoup soup = readObjSoup(
        kThreePoints +
        "o a\nf 1 2\nf\nf 1 2 3\nf 1 b 3\nf 1.5 2 3\nf 1/x 2 3\nf 1/1/y 2 3\nf 1,2,3\n");
    EXPECT_EQ(soup.faceCount(), 1);
    EXPECT_EQ(soup.faceObject, (Corners{0}));
    EXPECT_EQ(detailOf(soup.problems, ErrorCode::DegenerateFaceRecord),
              "2 faces left out: fewer than three corners, first at line 5; "
              "5 faces left out: not readable, first at line 8");
}

TEST(ObjReader, IgnoresWhatIsNoSurface) {
    const PolygonSoup soup =
        readObjSoup(kThreePoints +
                    "l 1 2 3\np 1 2\ns off\nvn 0 0 1\nvp 1 1\nmtllib C:\\a b.mtl\n"
                    "curv 0 1 1 2\nfoo 1 2 3\n\n#f 1 2 3\nf 1 2 3 # f 2 3 1\n");
    EXPECT_EQ(soup.faceCount(), 1);
    EXPECT_EQ(soup.positions.size(), 3u);
    EXPECT_TRUE(soup.problems.empty());
}

TEST(ObjReader, KeepsTheTextOfPositions) {
    const PolygonSoup soup = readObjSoup(
        "v 1.50 2.25 0.1\r\nv   -0.0\t+1e0 3.10   \nv 1 2 3 0.5 0.5 0.5\nv 1 2 3 1.0 # w\nf 1 2 3");
    EXPECT_EQ(positionText(soup, 0), "1.50 2.25 0.1");
    EXPECT_EQ(positionText(soup, 1), "-0.0\t+1e0 3.10");
    EXPECT_EQ(positionText(soup, 2), "1 2 3 0.5 0.5 0.5");
    EXPECT_EQ(positionText(soup, 3), "1 2 3 1.0");
    EXPECT_TRUE(std::signbit(soup.positions[1].x()));
}

TEST(ObjReader, RefusesAFileWithoutFaces) {
    const Result<PolygonSoup> empty = read(readObj, "");
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.error().code, ErrorCode::NoGeometry);
    EXPECT_EQ(empty.error().detail, "0 vertices, no faces");
    const Result<PolygonSoup> points = read(readObj, kThreePoints + "f 1 2\n");
    ASSERT_FALSE(points);
    EXPECT_EQ(points.error().code, ErrorCode::NoGeometry);
    EXPECT_EQ(points.error().subject.name, "test");
    EXPECT_EQ(points.error().detail,
              "3 vertices, no faces; 1 face left out: fewer than three corners, line 4");
    const std::vector<Wording>& parts = points.error().detail.arguments();
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_STREQ(parts[1].pattern(), "%1 %2, %3");  // in other languages too
}

TEST(ObjReader, StopsWhenCancelled) {
    std::string text = kThreePoints;
    for (int i = 0; i < 100000; ++i) {
        text += "f 1 2 3\n";
    }
    Progress progress;
    progress.cancel();
    const Result<PolygonSoup> soup =
        readObj(std::make_shared<const std::string>(text), "test", progress);
    ASSERT_FALSE(soup);
    EXPECT_EQ(soup.error().code, ErrorCode::Cancelled);
}

TEST(ObjReader, FillsUpCornersWithoutUvs) {
    const std::string points = kThreePoints + "vt 0 0\nvt 1 0\nvt 0 1\n";
    EXPECT_EQ(readObjSoup(points + "f 1 2 3\nf 1 2/2 3\nf 2 3 1\n").cornerUvs,
              (Corners{-1, -1, -1, -1, 1, -1, -1, -1, -1}));
    EXPECT_EQ(readObjSoup(points + "f 1 2 3\n").cornerUvs, (Corners{-1, -1, -1}));
    EXPECT_EQ(readObjSoup(points + "f 1/1 2/2\nf 1 x\nf 1 2 3/3\n").cornerUvs,
              (Corners{-1, -1, 2}));
    EXPECT_TRUE(readObjSoup(kThreePoints + "f 1 2/2 3\n").cornerUvs.empty());
}

TEST(ObjReader, AUnitThatAHeaderCommentStatesIsStated) {
    const std::pair<const char*, double> table[] = {
        {"# Units: millimetres. +Y up", 1},
        {"#units=cm", 10},
        {"# File units = Meters", 1000},
        {"# 1 unit = 2.54 cm", 25.4},
        {"# Unit: in", 25.4},
        {"# For more units in metres, see the community", 0},
        {"# units: furlongs", 0},
        {"# unit", 0},
        {"# Units:", 0},
        {"# Units: -1 m", 0},
        {"# Units: nan m", 0}};
    for (const auto& [comment, millimetres] : table) {
        const PolygonSoup soup =
            readObjSoup(std::string("# a garment\n") + comment + "\n" + kThreePoints + "f 1 2 3\n");
        ASSERT_EQ(soup.statedUnit.has_value(), millimetres > 0) << comment;
        if (soup.statedUnit) {
            EXPECT_EQ(millimetresPer(soup.statedUnit->unit), millimetres) << comment;
        }
    }
    // MakeHuman works in decimetres, unless the size speaks against it.
    for (const auto& [size, isTaken] :
         {std::pair("2.6", true), {"14", true}, {"1.4", false}, {"140", false}, {"1400", false}}) {
        const PolygonSoup soup =
            readObjSoup(std::string("# This is a mesh file for MakeHuman\nv 0 0 0\nv ") + size +
                        " 0 0\nv 0 1 0\nf 1 2 3\n");
        EXPECT_EQ(soup.statedUnit && soup.statedUnit->unit == LengthUnit::Decimetre, isTaken)
            << size;
    }
    // A unit without a name is left to the user.
    const PolygonSoup poser =
        readObjSoup("# Scale: Poser (1 unit = 8ft)\n" + kThreePoints + "f 1 2 3\n");
    EXPECT_FALSE(poser.statedUnit);
    ASSERT_EQ(poser.problems.size(), 1U);
    EXPECT_EQ(poser.problems[0].code, ErrorCode::UnitGuessed);
    EXPECT_NE(poser.problems[0].detail.find("2438.4"), std::string::npos);
    // Comments among the data are no header.
    EXPECT_FALSE(readObjSoup(kThreePoints + "# Units: mm\nf 1 2 3\n").statedUnit);
}

}  // namespace
}  // namespace toile::test
