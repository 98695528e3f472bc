// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/growth.h"

namespace toile {
namespace {

struct ObjLines {
    explicit ObjLines(const std::string& bytes) {
        std::istringstream in(bytes);
        for (std::string line; std::getline(in, line);) {
            if (line.starts_with("v ")) {
                v.push_back(line.substr(2));
            } else if (line.starts_with("vt ")) {
                vt.push_back(line.substr(3));
            } else if (line.starts_with("#")) {
                comments += line + "\n";
            } else {
                faces.push_back(line);
            }
        }
    }

    std::vector<std::string> v, vt, faces;
    std::string comments;
};

ObjLines write(const test::GarmentAndResults& all) {
    return ObjLines(writeObj(all.garment, all.results, all.marker));
}

TEST(WriteObj, RepeatsTheDigitsOfTheFile) {
    const ObjLines lines = write(test::handmadeGarment());
    EXPECT_EQ(lines.v, (std::vector<std::string>{"0 0 0", "1.50 0 -0", "1.5 1.250 0", "0 125e-2 0",
                                                 "3 0 0.000", "3.0 1.25 0", "0.75 2 0",
                                                 "9 9 9 0.5 0.5 0.5", "10 9 9",
                                                 "10     10 9",  // continued on the next line there
                                                 "7 7 7"}));
}

TEST(WriteObj, KeepsFacesInOrderWithOneVtPerPieceAndVertex) {
    const ObjLines lines = write(test::handmadeGarment());
    EXPECT_EQ(lines.faces, (std::vector<std::string>{
                               "g front_1", "f 1/1 2/2 3/3 4/4",  //
                               "g ring", "f 8 9 10",              // failed: no vt
                               "g front_1", "f 4/4 3/3 7/5",      //
                               "g back", "f 2/6 5/7 6/8 3/9",     // positions 2 and 3 once more
                               "g unassigned", "f 1 1 2"}));
}

TEST(WriteObj, WritesThePatternInMillimetresPlacedAndExact) {
    const ObjLines lines = write(test::handmadeGarment());
    EXPECT_EQ(lines.vt, (std::vector<std::string>{"100 0.1", "115 0.1", "115 12.6", "100 12.6",
                                                  "107.5 20.1",  // front
                                                  "0 0", "15 0", "15 12.5", "0 12.5"}));
}

TEST(WriteObj, SaysAtItsHeadWhatDiffersAndInWhichUnit) {
    const ObjLines lines = write(test::handmadeGarment());
    EXPECT_TRUE(lines.comments.starts_with("# Toile "));
    EXPECT_NE(lines.comments.find("v 1 to 11: by hand.obj, in cm"), std::string::npos);
    EXPECT_NE(lines.comments.find("vt in mm"), std::string::npos);
    const std::size_t differs = lines.comments.find("2 lines left out");
    ASSERT_NE(differs, std::string::npos);
    EXPECT_EQ(lines.comments.find("2 lines left out", differs + 1), std::string::npos);
    EXPECT_NE(lines.comments.find("1 face"), std::string::npos);
    EXPECT_EQ(lines.comments.find("read as centimetres"), std::string::npos);
}

TEST(WriteObj, AppendsFurtherFilesAndVerticesThatAreNotTheInputs) {
    test::GarmentAndResults all = test::handmadeGarment();
    test::addBinaryFile(all);
    const ObjLines lines = write(all);
    const std::vector<std::string> tail(lines.v.begin() + 11, lines.v.end());
    EXPECT_EQ(tail, (std::vector<std::string>{"0 0 0", "0.1 0 0", "0.1 1 0", "0 2 3", "0 1 0",
                                              "0.05 0.5 0"}));  // the added one, in inches
    const std::vector<std::string> faces(lines.faces.end() - 5, lines.faces.end());
    EXPECT_EQ(faces,
              (std::vector<std::string>{"g patch", "f 12/10 13/11 17/14", "f 13/11 14/12 17/14",
                                        "f 14/12 16/13 17/14", "f 16/13 12/10 17/14"}));
    EXPECT_EQ(lines.comments.find("nan"), std::string::npos);
    EXPECT_NE(lines.comments.find("1 vertex added"), std::string::npos);
    EXPECT_NE(lines.comments.find("1 vertex without a finite position"), std::string::npos);
    EXPECT_NE(lines.comments.find("1 face written as the triangles used"), std::string::npos);
}

TEST(WriteObj, KeepsGroupNamesApartAndInOneWord) {
    test::GarmentAndResults all = test::handmadeGarment();
    const std::vector<std::string> names{"front_1", "front 1", "unassigned"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto piece = std::make_shared<Piece>(*all.garment.pieces[i]);
        piece->name = names[i];
        all.garment.pieces[i] = piece;
    }
    const ObjLines lines = write(all);
    EXPECT_EQ(lines.faces[0], "g front_1");
    EXPECT_EQ(lines.faces[2], "g front_1_2");
    EXPECT_EQ(lines.faces[6], "g unassigned_2");
    EXPECT_EQ(lines.faces[8], "g unassigned");
}

TEST(WriteObj, GivesTheSameBytesTwiceAndInAnyLocale) {
    const test::GarmentAndResults all = test::handmadeGarment();
    const std::string bytes = writeObj(all.garment, all.results, all.marker);
    EXPECT_EQ(bytes, writeObj(all.garment, all.results, all.marker));
    const test::CommaLocale comma;
    EXPECT_EQ(bytes, writeObj(all.garment, all.results, all.marker));
}

/// A square grid of one piece without text, two triangles per cell.
test::GarmentAndResults gridGarment(int cells) {
    auto file = std::make_shared<SourceFile>();
    const auto soup = std::make_shared<PolygonSoup>();
    file->soup = soup;
    auto piece = std::make_shared<Piece>();
    const int side = cells + 1;
    piece->mesh.V.resize(side * side, 3);
    piece->mesh.F.resize(2 * cells * cells, 3);
    for (int i = 0; i < side * side; ++i) {
        piece->mesh.V.row(i) << i % side / 3.0, i / side / 7.0, 0;
        soup->positions.emplace_back(piece->mesh.V.row(i));
        piece->sourceVertex.push_back(i);
    }
    for (int t = 0; t < 2 * cells * cells; ++t) {
        const int a = t / 2 / cells * side + t / 2 % cells;
        piece->mesh.F.row(t) << a, (t % 2 == 0 ? a + 1 : a + side + 1),
            (t % 2 == 0 ? a + side + 1 : a + side);
        for (int k = 0; k < 3; ++k) {
            soup->corners.push_back(piece->mesh.F(t, k));
        }
        soup->faceStart.push_back(3 * (t + 1));
        piece->sourceFace.push_back(t);
    }
    auto result = std::make_shared<PieceResult>();
    result->piece = piece;
    result->flat.emplace().Q = piece->mesh.V.leftCols(2);
    return {{{file}, {piece}}, {result}, {{{0, {{1, 2}}}}, 0, 0}};
}

TEST(WriteObj, WritesEveryFaceOfALargePiece) {
    const test::GarmentAndResults all = gridGarment(100);
    const std::string bytes = writeObj(all.garment, all.results, all.marker);
    EXPECT_EQ(ObjLines(bytes).faces.size(), 20001u);  // with one g
}

TEST(WriteObjClock, IsLinearInTheFaces) {
    const auto writing = [](const test::GarmentAndResults& all) {
        return [&all] { writeObj(all.garment, all.results, all.marker); };
    };
    const test::GarmentAndResults some = gridGarment(150), more = gridGarment(300);
    EXPECT_LT(test::growth(writing(some), writing(more)), 8);
}

TEST(WriteObjLines, HasAnObjectForEachLayerWhereTheUvMapLies) {
    Drawing drawing;
    Points2 square(3, 2), stroke(2, 2);
    square << 10, 10, 110, 10, 110, 60;
    stroke << 20, 10, 20, 15;
    drawing.paths = {{"a", LayerKind::Cut, square, true},
                     {"b", LayerKind::Notches, stroke, false},
                     {"c", LayerKind::Check, square, true}};
    EXPECT_EQ(writeObjLines(drawing, 10),
              "# the lines of the pattern, where its UV map lies, in the unit of the mesh\n"
              "o pattern_cut\nv 0 0 0\nv 10 0 0\nv 10 5 0\nl -3 -2 -1 -3\n"
              "o pattern_notches\nv 1 0 0\nv 1 0.5 0\nl -2 -1\n");
}

}  // namespace
}  // namespace toile
