// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/divide.h"

#include <gtest/gtest.h>

#include "core/mesh/tri_mesh.h"

namespace toile {
namespace {

SourceFile fileOf(const std::string& obj, LengthUnit unit = LengthUnit::Millimetre) {
    Progress progress;
    auto soup = readObj(std::make_shared<const std::string>(obj), "test.obj", progress);
    EXPECT_TRUE(soup) << (soup ? "" : sentence(soup.error()));
    SourceFile file;
    file.path = "test.obj";
    file.unit = unit;
    file.soup = std::make_shared<const PolygonSoup>(std::move(*soup));
    return file;
}

/// Two triangles apart and a quad, in the order: b, a, b's second triangle.
constexpr const char* kTwoPieces =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
    "v 5 0 0\nv 6 0 0\nv 5 1 0\n"
    "o cuff\nf 5 6 7\no yoke\nf 1 2 3\nf 2 4 3\n";

TEST(Divide, FindsComponentsInOrderOfTheirFirstFace) {
    const DividedFile divided = divide(fileOf(kTwoPieces, LengthUnit::Centimetre), 3, "", {});
    const auto& pieces = divided.pieces;
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0]->name, "cuff");
    EXPECT_EQ(pieces[1]->name, "yoke");
    EXPECT_EQ(pieces[0]->file, 3);
    EXPECT_EQ(pieces[0]->sourceVertex, (std::vector<int>{4, 5, 6}));
    EXPECT_EQ(pieces[1]->sourceFace, (std::vector<int>{1, 2}));
    EXPECT_DOUBLE_EQ(pieces[1]->mesh.V(3, 0), 10);  // centimetres became millimetres
    EXPECT_TRUE(divided.problems.empty());
    EXPECT_EQ(divided.split.mode, SplitMode::Objects);
    EXPECT_FALSE(divided.split.reason.empty());
    ASSERT_FALSE(pieces[1]->defect);
    EXPECT_EQ(buildTriMesh(pieces[1]->mesh, pieces[1]->table)->n_faces(), 2U);
}

TEST(Divide, MakesNamesUnique) {
    const auto pieces = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"
                                      "g gore\nf 1 2 3\nf 4 5 6\n"),
                               0, "cap/", {})
                            .pieces;
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0]->name, "cap/gore");
    EXPECT_EQ(pieces[1]->name, "cap/gore 2");
}

TEST(Divide, PiecesWithoutANameAreCalledPiece) {
    const auto pieces = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 0, "", {}).pieces;
    EXPECT_EQ(pieces.front()->name, "piece");
}

TEST(Divide, ABadPieceLeavesTheGoodOnesAlone) {
    const DividedFile divided = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
                                              "v 5 0 0\nv 6 0 0\nv 5 1 0\n"
                                              "o bad\nf 1 2 3\nf 2 1 4\nf 1 2 5\n"
                                              "o good\nf 6 7 8\n"),
                                       0, "", {SplitMode::Objects, false});
    ASSERT_EQ(divided.pieces.size(), 2U);
    ASSERT_TRUE(divided.pieces[0]->defect);
    EXPECT_EQ(divided.pieces[0]->defect->code, ErrorCode::NonManifoldEdge);
    EXPECT_EQ(divided.pieces[0]->mesh.F.rows(), 3);  // still there to be shown
    EXPECT_FALSE(divided.pieces[1]->defect);
}

TEST(Divide, RepairsAndSaysSo) {
    const DividedFile divided = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                              "o yoke\nf 1 2 3\nf 2 3 4\n"),
                                       0, "", {});
    ASSERT_EQ(divided.pieces.size(), 1U);
    EXPECT_FALSE(divided.pieces[0]->defect);
    ASSERT_EQ(divided.problems.size(), 1U);
    EXPECT_EQ(name(divided.problems[0].code), "windings-turned");
    EXPECT_EQ(divided.problems[0].subject.name, "yoke");
}

/// Two squares welded along an edge, apart in the UV map; lengths there as in 3D.
constexpr const char* kTwoPanels =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 0 2\nv 2 2 2\n"
    "vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nvt 10 0\nvt 12 0\nvt 12 2\nvt 10 2\nvt 1 1\nvt 11 1\n"
    "v 1 1 0\nv 2 1 1\n"
    "f 1/1 2/2 7/9\nf 2/2 3/3 7/9\nf 3/3 4/4 7/9\nf 4/4 1/1 7/9\n"
    "f 2/5 5/6 8/10\nf 5/6 6/7 8/10\nf 6/7 3/8 8/10\nf 3/8 2/5 8/10\n";

TEST(Divide, TakesTheFlatPanelsOfTheUvMap) {
    const DividedFile divided = divide(fileOf(kTwoPanels), 0, "", {});
    EXPECT_EQ(divided.split.mode, SplitMode::Uv);
    ASSERT_EQ(divided.pieces.size(), 2U);
    EXPECT_EQ(divided.pieces[0]->name, "panel 1");
    EXPECT_EQ(divided.pieces[1]->name, "panel 2");
    for (const auto& piece : divided.pieces) {
        EXPECT_EQ(piece->mesh.V.rows(), 5);
        ASSERT_TRUE(piece->reference);
        EXPECT_NEAR(
            (piece->reference->colwise().maxCoeff() - piece->reference->colwise().minCoeff())
                .maxCoeff(),
            2, 1e-12);
    }
    EXPECT_EQ(divide(fileOf(kTwoPanels), 0, "", {SplitMode::Components}).pieces.size(), 1U);
}

TEST(Divide, APanelSewnToItselfComesOpen) {
    // A tube of four sides whose UV map is one strip: the first column stands at both ends.
    std::string obj;
    for (int k = 0; k < 4; ++k) {
        const char* corner[] = {"1 0 1", "1 0 -1", "-1 0 -1", "-1 0 1"};
        const char* above[] = {"1 2 1", "1 2 -1", "-1 2 -1", "-1 2 1"};
        obj += std::string("v ") + corner[k] + "\nv " + above[k] + "\n";
    }
    for (int k = 0; k <= 4; ++k) {
        obj += "vt " + std::to_string(2 * k) + " 0\nvt " + std::to_string(2 * k) + " 2\n";
    }
    for (int k = 0; k < 4; ++k) {
        const auto at = [](int column, int row) {
            return " " + std::to_string(2 * (column % 4) + row + 1) + "/" +
                   std::to_string(2 * column + row + 1);
        };
        obj += "f" + at(k, 0) + at(k + 1, 0) + at(k + 1, 1) + at(k, 1) + "\n";
    }
    const DividedFile open = divide(fileOf(obj), 0, "", {SplitMode::Uv});
    ASSERT_EQ(open.pieces.size(), 1U);
    EXPECT_FALSE(open.pieces[0]->defect);
    EXPECT_EQ(open.pieces[0]->mesh.V.rows(), 10);
    const DividedFile closed = divide(fileOf(obj), 0, "", {SplitMode::Components});
    ASSERT_TRUE(closed.pieces[0]->defect);
    EXPECT_EQ(closed.pieces[0]->defect->code, ErrorCode::SeveralLoops);
}

/// Two flat frames of four squares around a hole, with their own places as UV map.
TEST(Divide, AUvMapOfRingsIsNoPattern) {
    std::string obj;
    for (int frame = 0; frame < 2; ++frame) {
        for (int k = 0; k < 8; ++k) {
            const int side = k < 4 ? 3 : 1;
            const int x = (k % 4 == 1 || k % 4 == 2 ? side : -side) + 10 * frame;
            const int y = k % 4 > 1 ? side : -side;
            const std::string at = std::to_string(x) + " " + std::to_string(y);
            obj += "v " + at + " 0\nvt " + at + "\n";
        }
    }
    for (int k = 0; k < 8; ++k) {
        const int first = k / 4 * 8 + 1;
        obj += "f";
        for (const int corner :
             {first + k % 4, first + (k + 1) % 4, first + 4 + (k + 1) % 4, first + 4 + k % 4}) {
            obj += " " + std::to_string(corner) + "/" + std::to_string(corner);
        }
        obj += "\n";
    }
    const DividedFile divided = divide(fileOf(obj), 0, "", {});
    EXPECT_EQ(divided.split.mode, SplitMode::Components);
    ASSERT_EQ(divided.pieces.size(), 2U);
    EXPECT_FALSE(divided.pieces[0]->defect);  // a flat ring: the hole stays
    EXPECT_EQ(divided.pieces[0]->holes.size(), 1U);
}

TEST(Divide, AUvOfAPolygonOfManyCornersIsFound) {
    std::string obj, face = "f";
    for (int k = 0; k < 40; ++k) {
        const std::string at = std::to_string(k < 20 ? k : 39 - k) + " " + (k < 20 ? "0" : "9");
        obj += "v " + at + " 0\nvt " + at + "\n";
        face += " " + std::to_string(k + 1) + "/" + std::to_string(k + 1);
    }
    const DividedFile divided = divide(fileOf(obj + face + "\n"), 0, "", {SplitMode::Uv});
    ASSERT_EQ(divided.pieces.size(), 1U);
    ASSERT_TRUE(divided.pieces[0]->reference);
    EXPECT_TRUE(divided.pieces[0]->reference->isApprox(divided.pieces[0]->mesh.V.leftCols<2>()));
}

TEST(Divide, SplitsByMaterialsAndGroups) {
    const std::string obj =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
        "usemtl denim\ng left\nf 1 2 3\nusemtl lining\ng right\nf 2 4 3\n";
    const auto byMaterial = divide(fileOf(obj), 0, "", {SplitMode::Materials}).pieces;
    ASSERT_EQ(byMaterial.size(), 2U);
    EXPECT_EQ(byMaterial[1]->name, "lining");
    const DividedFile automatic = divide(fileOf(obj), 0, "", {});
    EXPECT_EQ(automatic.split.mode, SplitMode::Groups);
    EXPECT_EQ(automatic.pieces[0]->name, "left");
}

TEST(SplitModes, ReadBackTheirNames) {
    for (const SplitMode mode :
         {SplitMode::Auto, SplitMode::Components, SplitMode::Objects, SplitMode::Groups,
          SplitMode::Materials, SplitMode::Uv, SplitMode::Seams}) {
        EXPECT_EQ(parseSplitMode(name(mode)), mode);
    }
    EXPECT_FALSE(parseSplitMode("magic"));
}

}  // namespace
}  // namespace toile
