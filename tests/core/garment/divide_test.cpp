// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/divide.h"

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
    file.soup = std::move(*soup);
    return file;
}

/// Two triangles apart and a quad, in the order: b, a, b's second triangle.
constexpr const char* kTwoPieces =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
    "v 5 0 0\nv 6 0 0\nv 5 1 0\n"
    "o cuff\nf 5 6 7\no yoke\nf 1 2 3\nf 2 4 3\n";

TEST(Divide, FindsComponentsInOrderOfTheirFirstFace) {
    Problems problems;
    const auto pieces = divide(fileOf(kTwoPieces, LengthUnit::Centimetre), 3, "", problems);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0]->name, "cuff");
    EXPECT_EQ(pieces[1]->name, "yoke");
    EXPECT_EQ(pieces[0]->file, 3);
    EXPECT_EQ(pieces[0]->sourceVertex, (std::vector<int>{4, 5, 6}));
    EXPECT_EQ(pieces[1]->sourceFace, (std::vector<int>{1, 2}));
    EXPECT_DOUBLE_EQ(pieces[1]->mesh.V(3, 0), 10);  // centimetres became millimetres
    EXPECT_TRUE(problems.empty());
    ASSERT_TRUE(pieces[1]->halfedges);
    EXPECT_EQ(pieces[1]->halfedges->n_faces(), 2U);
}

TEST(Divide, MakesNamesUnique) {
    Problems problems;
    const auto pieces = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"
                                      "g gore\nf 1 2 3\nf 4 5 6\n"),
                               0, "cap/", problems);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0]->name, "cap/gore");
    EXPECT_EQ(pieces[1]->name, "cap/gore 2");
}

TEST(Divide, PiecesWithoutANameAreCalledPiece) {
    Problems problems;
    const auto pieces = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 0, "", problems);
    EXPECT_EQ(pieces.front()->name, "piece");
}

TEST(Divide, ABadPieceLeavesTheGoodOnesAlone) {
    Problems problems;
    const auto pieces = divide(fileOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
                                      "v 5 0 0\nv 6 0 0\nv 5 1 0\n"
                                      "o bad\nf 1 2 3\nf 2 1 4\nf 1 2 5\no good\nf 6 7 8\n"),
                               0, "", problems);
    ASSERT_EQ(pieces.size(), 2U);
    ASSERT_TRUE(pieces[0]->defect);
    EXPECT_EQ(pieces[0]->defect->code, ErrorCode::NonManifoldEdge);
    EXPECT_EQ(pieces[0]->mesh.F.rows(), 3);  // still there to be shown
    EXPECT_FALSE(pieces[1]->defect);
}

}  // namespace
}  // namespace toile
