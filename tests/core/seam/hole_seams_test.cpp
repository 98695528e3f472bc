// SPDX-License-Identifier: GPL-3.0-or-later
// A patch that was cut out of a piece is sewn to the rim of the hole it left.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::asPiece;

bool inPatch(const Eigen::RowVector3d& p) {
    return p.x() > 40 && p.x() < 70 && p.y() > 30 && p.y() < 80;
}

bool inSecondPatch(const Eigen::RowVector3d& p) {
    return p.x() > 10 && p.x() < 30 && p.y() > 40 && p.y() < 60;
}

MeshArrays sheet() {
    return test::rectangle(0, 0, 100, 120, 10, 12);
}

MeshArrays sheetWithHole() {
    return test::part(sheet(), [](const auto& p) -> bool { return !inPatch(p); });
}

MeshArrays patch() {
    return test::part(sheet(), inPatch);
}

TEST(HoleSeams, ThePatchIsSewnToTheRimAllRound) {
    for (const bool patchFirst : {false, true}) {
        Pieces pieces{asPiece(sheetWithHole(), "back"), asPiece(patch(), "pocket")};
        if (patchFirst) {
            std::swap(pieces[0], pieces[1]);
        }
        for (const bool sameFile : {false, true}) {
            const Pieces sewn = sameFile ? test::welded(pieces) : pieces;
            const SeamGraph graph = findSeams(sewn);
            test::expectValid(graph, sewn);
            const auto seams = test::only(graph, SeamKind::Seam);
            ASSERT_EQ(seams.size(), 1U);
            const Seam& seam = seams.front();
            EXPECT_EQ(seam.name, patchFirst ? "pocket / back" : "back / pocket");
            EXPECT_EQ(seam.left.piece, 0);
            EXPECT_EQ(seam.right.piece, 1);
            EXPECT_EQ(seam.left.loop, patchFirst ? 0 : 1);
            EXPECT_EQ(seam.right.loop, patchFirst ? 1 : 0);
            EXPECT_TRUE(seam.closed);
            EXPECT_NEAR(seam.length3d[0], 160, 1e-9);
            EXPECT_NEAR(seam.length3d[1], 160, 1e-9);
            // The two lines are the same points, one after the other.
            const Points3 left = spaceLine(seam.left, *sewn[0]);
            const Points3 right = spaceLine(seam.right, *sewn[1]);
            ASSERT_EQ(left.rows(), right.rows());
            EXPECT_LT((left - right).cwiseAbs().maxCoeff(), 1e-9);
            // Only the outline of the sheet is free.
            ASSERT_EQ(test::only(graph, SeamKind::Free).size(), 1U);
            EXPECT_EQ(test::only(graph, SeamKind::Free).front().name, "back, free edge");
            EXPECT_NEAR(test::only(graph, SeamKind::Free).front().length3d[0], 440, 1e-9);
        }
    }
}

TEST(HoleSeams, AHoleThatNothingIsSewnToIsNoEdgeOfTheGraph) {
    const Pieces pieces{asPiece(sheetWithHole(), "back")};
    const SeamGraph graph = findSeams(pieces);
    ASSERT_EQ(graph.seams.size(), 1U);
    EXPECT_EQ(graph.seams.front().name, "back, free edge");
    EXPECT_EQ(graph.seams.front().left.loop, 0);
    EXPECT_TRUE(graph.seamsOfHoles.front().empty());
}

TEST(HoleSeams, TwoPatchesFindTheirOwnHoles) {
    const Pieces pieces = test::welded(
        {asPiece(test::part(sheet(),
                            [](const auto& p) -> bool { return !inPatch(p) && !inSecondPatch(p); }),
                 "back"),
         asPiece(patch(), "pocket"), asPiece(test::part(sheet(), inSecondPatch), "flap")});
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    const Seam pocket = test::named(graph, "back / pocket");
    const Seam flap = test::named(graph, "back / flap");
    EXPECT_NEAR(pocket.length3d[0], 160, 1e-9);
    EXPECT_NEAR(pocket.length3d[1], 160, 1e-9);
    EXPECT_NEAR(flap.length3d[0], 80, 1e-9);
    EXPECT_NEAR(flap.length3d[1], 80, 1e-9);
    EXPECT_NE(pocket.left.loop, flap.left.loop);
    EXPECT_EQ(graph.seamsOfHoles[0].size(), 2U);
}

TEST(HoleSeams, APatchOfTwoPartsLeavesTwoSeams) {
    const Pieces pieces = test::welded(
        {asPiece(sheetWithHole(), "back"),
         asPiece(
             test::part(sheet(), [](const auto& p) -> bool { return inPatch(p) && p.y() < 60; }),
             "lower"),
         asPiece(
             test::part(sheet(), [](const auto& p) -> bool { return inPatch(p) && p.y() > 60; }),
             "upper")});
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    EXPECT_NEAR(test::named(graph, "back / lower").length3d[0], 90, 1e-9);
    EXPECT_NEAR(test::named(graph, "back / upper").length3d[0], 70, 1e-9);
    EXPECT_NEAR(test::named(graph, "lower / upper").length3d[0], 30, 1e-9);
}

TEST(HoleSeams, HalfAPatchLeavesTheRestOfTheRimFree) {
    const Pieces pieces = test::welded(
        {asPiece(sheetWithHole(), "back"),
         asPiece(
             test::part(sheet(), [](const auto& p) -> bool { return inPatch(p) && p.y() < 60; }),
             "lower")});
    const SeamGraph graph = findSeams(pieces);
    test::expectValid(graph, pieces);
    EXPECT_NEAR(test::named(graph, "back / lower").length3d[0], 90, 1e-9);
    double free = 0;
    for (const Seam& edge : test::only(graph, SeamKind::Free)) {
        free += edge.left.loop > 0 ? edge.length3d[0] : 0;
    }
    EXPECT_NEAR(free, 70, 1e-9);
}

TEST(HoleSeams, TheMeasureIsThatOfTheFlatRim) {
    const Pieces pieces = test::welded({asPiece(sheetWithHole(), "back"), asPiece(patch(), "p")});
    const Seam seam = test::only(findSeams(pieces), SeamKind::Seam).at(0);
    FlatPiece back, small;
    back.Q = pieces[0]->mesh.V.leftCols(2);
    small.Q = pieces[1]->mesh.V.leftCols(2);
    const SeamMeasure same = measureSeam(seam, *pieces[0], back, *pieces[1], small);
    EXPECT_NEAR(same.errorMm, 0, 1e-9);
    // A hole's rim may come out longer: the ledger says by how much.
    back.Q *= 1.01;
    const SeamMeasure longer = measureSeam(seam, *pieces[0], back, *pieces[1], small);
    EXPECT_NEAR(longer.length2dLeft, 161.6, 1e-9);
    EXPECT_NEAR(longer.errorMm, 1.6, 1e-9);
    // And the order that takes it out runs along it.
    for (const Eigen::Vector3d& point : joinAlong(seam, pieces).points) {
        const bool onRim = std::abs(point.x() - 40) < 1e-9 || std::abs(point.x() - 70) < 1e-9 ||
                           std::abs(point.y() - 30) < 1e-9 || std::abs(point.y() - 80) < 1e-9;
        EXPECT_TRUE(onRim);
    }
}

}  // namespace
}  // namespace toile
