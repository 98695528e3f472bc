// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/cut_pieces.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// A piece that knows where it comes from, as `divide` makes them.
std::shared_ptr<const Piece> fromFile(MeshArrays mesh, const std::string& name) {
    auto piece = std::make_shared<Piece>(makePiece(name, std::move(mesh)));
    for (int v = 0; v < piece->mesh.V.rows(); ++v) {
        piece->sourceVertex.push_back(1000 + v);
    }
    for (int f = 0; f < piece->mesh.F.rows(); ++f) {
        piece->sourceFace.push_back(2000 + f);
    }
    return piece;
}

CutPieces cut(const Pieces& pieces, const std::vector<UserCut>& cuts, bool automatic) {
    return cutPieces(pieces, cuts, automatic, Progress());
}

MeshArrays moved(MeshArrays mesh, double x) {
    mesh.V.col(0).array() += x;
    return mesh;
}

TEST(CutPieces, HandOnPiecesWithoutCutsByPointer) {
    const Pieces pieces{fromFile(test::planeGrid(4, 4, 10), "front"),
                        fromFile(test::tube(16, 6), "sleeve")};
    const CutPieces none = cut(pieces, {}, false);
    EXPECT_EQ(none.pieces, pieces);
    EXPECT_TRUE(none.cuts.empty());
    const CutPieces automatic = cut(pieces, {}, true);
    EXPECT_EQ(automatic.pieces[0], pieces[0]);
    EXPECT_NE(automatic.pieces[1], pieces[1]);
}

TEST(CutPieces, OpenATubeByItselfAndSaySo) {
    const CutPieces made = cut({fromFile(test::tube(24, 9), "sleeve")}, {}, true);
    ASSERT_EQ(made.pieces.size(), 1U);
    EXPECT_FALSE(made.pieces[0]->defect);
    EXPECT_EQ(made.pieces[0]->name, "sleeve");
    ASSERT_EQ(made.cuts.size(), 1U);
    EXPECT_EQ(made.cuts[0].author, CutAuthor::Automatic);
    EXPECT_EQ(made.cuts[0].name, "sleeve, automatic cut 1");
    EXPECT_EQ(made.cuts[0].piece, "sleeve");
    EXPECT_NEAR(made.cuts[0].length, 180, 1e-9);
    for (const int source : made.pieces[0]->sourceVertex) {
        EXPECT_TRUE(source == -1 || source >= 1000);
    }
}

TEST(CutPieces, GoToThePieceNearestToTheirPoints) {
    const Pieces pieces{fromFile(test::planeGrid(10, 10, 10), "left"),
                        fromFile(moved(test::planeGrid(10, 10, 10), 200), "right")};
    const UserCut across{"across", UserCut::Kind::Path, {{200.4, 50, 2}, {299.6, 52, 2}}, false};
    const CutPieces made = cut(pieces, {across}, false);
    ASSERT_EQ(made.pieces.size(), 3U);
    EXPECT_EQ(made.pieces[0], pieces[0]);
    EXPECT_EQ(made.pieces[1]->name, "right 1");
    EXPECT_EQ(made.pieces[2]->name, "right 2");
    EXPECT_EQ(made.cuts[0].author, CutAuthor::User);
    EXPECT_NEAR(made.cuts[0].length, 100, 0.1);
    const double area =
        triangleAreas3d(made.pieces[1]->mesh).sum() + triangleAreas3d(made.pieces[2]->mesh).sum();
    EXPECT_NEAR(area, 1e4, 1e-8);
}

TEST(CutPieces, NumberPartsPastNamesThatAreTaken) {
    const Pieces pieces{fromFile(test::planeGrid(6, 6, 10), "leg"),
                        fromFile(moved(test::planeGrid(6, 6, 10), 200), "leg 1")};
    const UserCut across{"across", UserCut::Kind::Path, {{0, 31, 0}, {60, 31, 0}}, true};
    const CutPieces made = cut(pieces, {across}, false);
    ASSERT_EQ(made.pieces.size(), 3U);
    EXPECT_EQ(made.pieces[0]->name, "leg 2");
    EXPECT_EQ(made.pieces[1]->name, "leg 3");
    EXPECT_EQ(made.pieces[2]->name, "leg 1");
}

TEST(CutPieces, KeepTheReferencePanel) {
    auto piece = std::make_shared<Piece>(*fromFile(test::planeGrid(6, 6, 10), "front"));
    piece->reference = piece->mesh.V.leftCols<2>() * 2;
    const UserCut dart{"dart", UserCut::Kind::Dart, {{31, 1, 0}, {33, 37, 0}}, false};
    const CutPieces made = cut({piece}, {dart}, false);
    ASSERT_EQ(made.pieces.size(), 1U);
    const Piece& open = *made.pieces[0];
    ASSERT_TRUE(open.reference);
    EXPECT_GT(open.mesh.V.rows(), piece->mesh.V.rows());
    EXPECT_LT((*open.reference - 2 * open.mesh.V.leftCols<2>()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CutPieces, OneThatFailsLeavesTheOthersAlone) {
    const Pieces pieces{fromFile(test::planeGrid(10, 10, 10), "front")};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<UserCut> cuts{
        {"no points", UserCut::Kind::Path, {}, false},
        {"not finite", UserCut::Kind::Path, {{nan, 0, 0}, {1, 1, 0}}, false},
        {"far away", UserCut::Kind::Path, {{5000, 0, 0}, {5000, 90, 0}}, false},
        {"one point", UserCut::Kind::Path, {{10, 10, 0}}, false},
        {"on the rim", UserCut::Kind::Path, {{0, 0, 0}, {100, 0, 0}}, true},
        {"good", UserCut::Kind::Path, {{50, 0, 0}, {50, 100, 0}}, true}};
    const CutPieces made = cut(pieces, cuts, false);
    EXPECT_EQ(made.pieces.size(), 2U);
    ASSERT_EQ(made.cuts.size(), 1U);
    EXPECT_EQ(made.cuts[0].name, "good");
    ASSERT_EQ(made.problems.size(), 5U);
    for (const Error& problem : made.problems) {
        EXPECT_EQ(problem.code, ErrorCode::CutImpossible) << sentence(problem);
        EXPECT_FALSE(problem.subject.name.empty());
    }
}

TEST(CutPieces, SayShortlyThatAPointIsFarOut) {
    const Pieces pieces{fromFile(test::planeGrid(10, 10, 10), "front")};
    for (const double far : {1e13, 1e100, -1e300}) {
        const UserCut out{"out", UserCut::Kind::Path, {{50, 0, 0}, {far, 0, 0}}, false};
        const CutPieces made = cut(pieces, {out}, false);
        ASSERT_EQ(made.problems.size(), 1U) << far;
        EXPECT_NE(made.problems[0].detail.find("e+"), std::string::npos) << far;
        EXPECT_LT(sentence(made.problems[0]).size(), 150U) << sentence(made.problems[0]);
    }
}

TEST(CutPieces, ATangleIsRefusedAndTheOthersAreMade) {
    const Pieces pieces{fromFile(test::planeGrid(2, 2, 50), "front")};
    const UserCut good{"good", UserCut::Kind::Path, {{50, 0, 0}, {50, 100, 0}}, false};
    UserCut tangle{"tangle", UserCut::Kind::Path, {}, false};
    for (int i = 0; i < 3000; ++i) {
        tangle.points.emplace_back(i * 37 % 101, i * 59 % 97, 0);
    }
    const CutPieces made = cut(pieces, {tangle, good, tangle}, false);
    const CutPieces expected = cut(pieces, {good}, false);
    ASSERT_EQ(made.pieces.size(), 2U);
    for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_EQ(made.pieces[p]->mesh.V, expected.pieces[p]->mesh.V);
        EXPECT_EQ(made.pieces[p]->mesh.F, expected.pieces[p]->mesh.F);
    }
    ASSERT_EQ(made.problems.size(), 2U);
    for (const Error& problem : made.problems) {
        EXPECT_EQ(problem.code, ErrorCode::CutImpossible);
        EXPECT_EQ(problem.subject.name, "tangle");
        EXPECT_NE(problem.detail.find("in front, it crosses itself"), std::string::npos);
    }
    // Alone, it leaves the very piece.
    EXPECT_EQ(cut(pieces, {tangle}, false).pieces, pieces);
}

TEST(CutPieces, SayHowFarTheyAre) {
    const Pieces pieces{fromFile(test::planeGrid(4, 4, 10), "front"),
                        fromFile(test::tube(16, 6), "sleeve")};
    const UserCut across{"across", UserCut::Kind::Path, {{0, 21, 0}, {40, 21, 0}}, false};
    Progress progress;
    EXPECT_EQ(cutPieces(pieces, {across}, true, progress).cuts.size(), 2U);
    EXPECT_NEAR(progress.fraction(), 1, 1e-12);
    Progress cancelled;
    cancelled.cancel();
    EXPECT_TRUE(cutPieces(pieces, {across}, true, cancelled).cuts.empty());
    EXPECT_EQ(cancelled.fraction(), 0);
}

TEST(CutPieces, APieceThatNoCutOpensKeepsItsDefect) {
    const CutPieces made = cut({fromFile(test::moebiusStrip(12), "strip")}, {}, true);
    ASSERT_EQ(made.pieces.size(), 1U);
    ASSERT_TRUE(made.pieces[0]->defect);
    EXPECT_EQ(made.pieces[0]->defect->code, ErrorCode::NotOrientable);
}

/// A flat ring: a poncho.
MeshArrays ring() {
    return test::without(test::planeGrid(20, 20, 10), [](int f) {
        const int column = f / 2 % 20, row = f / 40;
        return column > 5 && column < 14 && row > 5 && row < 14;
    });
}

TEST(Holes, AFlatRingIsADiskWithAHole) {
    const Piece poncho = makePiece("poncho", ring());
    ASSERT_FALSE(poncho.defect);
    EXPECT_EQ(poncho.boundary.size(), 80U);
    ASSERT_EQ(poncho.holes.size(), 1U);
    EXPECT_EQ(poncho.holes[0].size(), 32U);
    EXPECT_EQ(loopLengths(poncho), (std::vector<double>{800, 320}));
    const Piece filled = withHolesFilled(poncho);
    EXPECT_FALSE(filled.defect);
    EXPECT_TRUE(filled.holes.empty());
    EXPECT_EQ(filled.boundary, poncho.boundary);
    EXPECT_EQ(filled.mesh.F.topRows(poncho.mesh.F.rows()), poncho.mesh.F);
}

TEST(Holes, TheEndsOfATubeAreNone) {
    const Piece sleeve = makePiece("sleeve", test::tube(24, 9));
    ASSERT_TRUE(sleeve.defect);
    EXPECT_EQ(sleeve.defect->code, ErrorCode::SeveralLoops);
}

/// Trousers with their hems folded inwards: the rim of such a hem lies in a flat ring.
TEST(Holes, AHemFoldedInwardsIsNone) {
    MeshArrays tube = test::tube(24, 9);
    tube.V.topRows(24).leftCols<1>() *= 0.5;
    tube.V.topRows(24).rightCols<1>() *= 0.5;
    tube.V.topRows(24).col(1) = tube.V.row(24).col(1).replicate(24, 1);
    const Piece sleeve = makePiece("sleeve", tube);
    ASSERT_TRUE(sleeve.defect);
    EXPECT_EQ(sleeve.defect->code, ErrorCode::SeveralLoops);
}

}  // namespace
}  // namespace toile
