// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/find_seams.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::asPiece;
using test::named;
using test::only;
using test::rectangle;

TEST(FindSeams, TwoRectanglesSampledAlike) {
    const Pieces pieces{asPiece(rectangle(0, 0, 50, 100, 5, 10), "front"),
                        asPiece(rectangle(50, 0, 70, 100, 7, 10), "back")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    const Seam seam = named(graph, "front / back");
    EXPECT_EQ(seam.kind, SeamKind::Seam);
    EXPECT_EQ(seam.matches.size(), 11U);
    EXPECT_NEAR(seam.length3d[0], 100, 1e-12);
    EXPECT_NEAR(seam.length3d[1], 100, 1e-12);
    EXPECT_TRUE(seam.right.reversed);
    EXPECT_EQ(seam.left.count, 10);
    EXPECT_EQ(seam.right.count, 10);
    EXPECT_NEAR(named(graph, "front, free edge").length3d[0], 200, 1e-12);
    EXPECT_NEAR(named(graph, "back, free edge").length3d[0], 240, 1e-12);
    EXPECT_EQ(graph.seams.size(), 3U);
}

TEST(FindSeams, TwoRectanglesSampledDifferently) {
    const Pieces pieces{asPiece(rectangle(0, 0, 50, 100, 5, 10), "front"),
                        asPiece(rectangle(50.1, 0, 70, 100, 7, 13), "back")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    const Seam seam = named(graph, "front / back");
    EXPECT_EQ(seam.matches.size(), 2U + 9 + 12);
    EXPECT_NEAR(seam.gap, 0.1, 1e-12);
    for (const SeamMatch& m : seam.matches) {
        EXPECT_NEAR(m.left - seam.left.start, seam.right.start - m.right, 1e-9);
    }
}

TEST(FindSeams, ThreePiecesAtACorner) {
    const Pieces pieces{asPiece(rectangle(0, 0, 200, 80, 17, 7), "skirt"),
                        asPiece(rectangle(0, 80.2, 100, 90, 10, 9), "left"),
                        asPiece(rectangle(100.2, 80.2, 100, 90, 9, 8), "right")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    EXPECT_EQ(only(graph, SeamKind::Seam).size(), 3U);
    EXPECT_NEAR(named(graph, "skirt / left").length3d[0], 100, 2);
    EXPECT_NEAR(named(graph, "skirt / left").length3d[1], 100, 1e-9);
    EXPECT_NEAR(named(graph, "skirt / right").length3d[0], 100, 2);
    EXPECT_NEAR(named(graph, "left / right").length3d[0], 90, 1e-9);
    EXPECT_EQ(only(graph, SeamKind::Free).size(), 3U);
}

TEST(FindSeams, FourPiecesMeetInAPoint) {
    const Pieces pieces{asPiece(rectangle(0, 0, 60, 60, 6, 6), "a"),
                        asPiece(rectangle(60, 0, 60, 60, 5, 5), "b"),
                        asPiece(rectangle(0, 60, 60, 60, 7, 7), "c"),
                        asPiece(rectangle(60, 60, 60, 60, 8, 8), "d")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    for (const char* name : {"a / b", "a / c", "b / d", "c / d"}) {
        EXPECT_NEAR(named(graph, name).length3d[0], 60, 1e-9);
    }
    EXPECT_EQ(only(graph, SeamKind::Seam).size(), 4U);
}

TEST(FindSeams, ACylinderCutOpenIsSewnToItself) {
    const Pieces pieces{
        asPiece(test::cylinderSector(24, 9, 40, 2 * std::numbers::pi, 120), "sleeve")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    const Seam seam = named(graph, "sleeve / itself");
    EXPECT_EQ(seam.kind, SeamKind::Seam);
    EXPECT_NEAR(seam.length3d[0], 120, 1e-9);
    EXPECT_NEAR(seam.length3d[1], 120, 1e-9);
    EXPECT_EQ(only(graph, SeamKind::Free).size(), 2U);
}

TEST(FindSeams, ASlitFromTheEdgeIsADart) {
    const Pieces apart{asPiece(test::withSlit(rectangle(0, 0, 100, 80, 10, 8), 10, 4, 5), "back")};
    for (const Pieces& pieces : {apart, test::welded(apart)}) {
        const SeamGraph graph = findSeams(pieces);
        test::expectValid(graph, pieces);
        const Seam dart = named(graph, "back, dart");
        EXPECT_EQ(dart.kind, SeamKind::Dart);
        EXPECT_NEAR(dart.length3d[0], 50, 1e-9);
        EXPECT_NEAR(dart.length3d[1], 50, 1e-9);
        EXPECT_NEAR(dart.left.end, dart.right.end, 1e-9);  // the point
        EXPECT_EQ(graph.seams.size(), 2U);
    }
}

TEST(FindSeams, PillowsAreSewnAllAround) {
    const MeshArrays top = rectangle(0, 0, 60, 40, 6, 4);
    const Pieces pieces{asPiece(top, "top"), asPiece(test::woundAgainst(top), "bottom")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    ASSERT_EQ(graph.seams.size(), 1U);
    EXPECT_TRUE(graph.seams[0].closed);
    EXPECT_NEAR(graph.seams[0].length3d[0], 200, 1e-9);
    EXPECT_NEAR(graph.seams[0].length3d[1], 200, 1e-9);
}

TEST(FindSeams, TwoSeamsBetweenTheSamePiecesStaySeparate) {
    const double half = std::numbers::pi;
    MeshArrays back = test::cylinderSector(12, 9, 40, half, 120);
    back.V.col(0) *= -1;  // half a turn about the cylinder's axis y
    back.V.col(2) *= -1;
    const Pieces pieces{asPiece(test::cylinderSector(12, 9, 40, half, 120), "front"),
                        asPiece(back, "back")};
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    EXPECT_NEAR(named(graph, "front / back, seam 1").length3d[0], 120, 1e-9);
    EXPECT_NEAR(named(graph, "front / back, seam 2").length3d[1], 120, 1e-9);
    EXPECT_EQ(graph.seams.size(), 6U);
}

TEST(FindSeams, PiecesWithoutAnOutlineHaveNoSeams) {
    EXPECT_TRUE(findSeams({}).seams.empty());
    const Pieces pieces{asPiece(test::tube(8, 3), "tube"), asPiece(test::octahedron(), "ball"),
                        asPiece(rectangle(0, 0, 50, 100, 5, 10), "front")};
    const SeamGraph graph = findSeams(pieces);
    ASSERT_EQ(graph.seams.size(), 1U);
    EXPECT_EQ(graph.seams[0].name, "front, free edge");
    EXPECT_TRUE(graph.seams[0].closed);
    EXPECT_TRUE(graph.seamsOfEdge[0].empty());
}

TEST(FindSeams, SaysHowFarItIsAndCanBeCancelled) {
    const Pieces pieces{asPiece(rectangle(0, 0, 50, 100, 5, 10), "front"),
                        asPiece(rectangle(50, 0, 70, 100, 7, 10), "back")};
    Progress progress;
    EXPECT_FALSE(findSeams(pieces, {}, progress).seams.empty());
    EXPECT_EQ(progress.fraction(), 1);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_TRUE(findSeams(pieces, {}, cancelled).seams.empty());
    EXPECT_LT(cancelled.fraction(), 1);
}

}  // namespace
}  // namespace toile
