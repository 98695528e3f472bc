// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

std::shared_ptr<const Piece> named(MeshArrays mesh, const std::string& name) {
    Piece piece = makePiece(name, std::move(mesh));
    piece.sourceVertex.assign(static_cast<std::size_t>(piece.mesh.V.rows()), 0);
    piece.sourceFace.assign(static_cast<std::size_t>(piece.mesh.F.rows()), 0);
    return std::make_shared<const Piece>(std::move(piece));
}

TEST(OpeningCuts, OpenOnePieceAndLeaveTheOthers) {
    MeshArrays beside = test::tube(24, 9);
    beside.V.col(0).array() += 300;
    const Pieces legs{named(test::tube(24, 9), "left"), named(std::move(beside), "right")};
    ASSERT_TRUE(isOpenable(*legs[0]));
    const auto cuts = openingCuts(*legs[0], true);
    ASSERT_TRUE(cuts);
    ASSERT_EQ(cuts->size(), 1U);
    EXPECT_EQ(cuts->front().points.size(), 3U);
    const CutPieces made = cutPieces(legs, *cuts, false, Progress());
    ASSERT_EQ(made.pieces.size(), 2U);
    EXPECT_FALSE(made.pieces[0]->defect);
    EXPECT_EQ(made.pieces[1], legs[1]);
    EXPECT_EQ(made.cuts.front().author, CutAuthor::User);
}

TEST(OpeningCuts, OpenTheOneOfTwoThatMeetAtAllRims) {
    MeshArrays shell = test::tube(24, 9);
    const double middle = shell.V.col(1).mean(), half = shell.V.col(1).maxCoeff() - middle;
    for (Eigen::Index v = 0; v < shell.V.rows(); ++v) {
        const double height = (shell.V(v, 1) - middle) / half;
        const double out = 1.2 - 0.2 * height * height;
        shell.V(v, 0) *= out;
        shell.V(v, 2) *= out;
    }
    const Pieces both{named(test::tube(24, 9), "lining"), named(std::move(shell), "shell")};
    for (std::size_t opened = 0; opened < 2; ++opened) {
        const auto cuts = openingCuts(*both[opened], true);
        ASSERT_TRUE(cuts);
        const CutPieces made = cutPieces(both, *cuts, false, Progress());
        ASSERT_EQ(made.pieces.size(), 2U);
        EXPECT_FALSE(made.pieces[opened]->defect);
        EXPECT_EQ(made.pieces[1 - opened], both[1 - opened]);
    }
}

TEST(OpeningCuts, OpenWhateverAutomaticCutsOpen) {
    for (const MeshArrays& mesh : {test::piercedTorus(32, 16), test::closedTorus(32, 16),
                                   test::sphere(16), test::closedBox(6, 60)}) {
        const auto piece = named(mesh, "piece");
        for (const bool isWhole : {true, false}) {
            const auto cuts = openingCuts(*piece, isWhole);
            ASSERT_TRUE(cuts) << sentence(cuts.error());
            const CutPieces made = cutPieces({piece}, *cuts, false, Progress());
            ASSERT_EQ(made.pieces.size(), 1U);
            EXPECT_FALSE(made.pieces[0]->defect);
        }
    }
}

TEST(OpeningCuts, NeedSomethingToOpen) {
    EXPECT_FALSE(isOpenable(*named(test::planeGrid(4, 4, 10), "sheet")));
    EXPECT_FALSE(isOpenable(*named(test::moebiusStrip(12), "strip")));
}

}  // namespace
}  // namespace toile
