// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/slits.h"

#include <gtest/gtest.h>

#include "core/assemble/join_pieces.h"
#include "core/cut/cut_along.h"
#include "core/cut/surface_paths.h"
#include "core/quality/measures.h"
#include "core/toile/pipeline.h"
#include "tests/core/cut/surface.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// A sheet of 12 x 12 squares of 10 mm, open along these ways of vertices.
std::shared_ptr<Piece> slitSheet(const std::vector<std::vector<int>>& ways) {
    const test::Surface sheet(test::planeGrid(12, 12, 10));
    std::vector<PathPolyline> paths;
    for (const auto& way : ways) {
        paths.push_back(polylineOf(sheet.links, way));
    }
    const auto cut = cutAlong(sheet.mesh, paths);
    Piece piece = makePiece("sheet", cut->mesh);
    piece.sourceVertex.assign(static_cast<std::size_t>(piece.mesh.V.rows()), 0);
    piece.sourceFace.assign(static_cast<std::size_t>(piece.mesh.F.rows()), 0);
    return std::make_shared<Piece>(std::move(piece));
}

Pieces closed(const Pieces& pieces) {
    std::vector<UserJoin> joins;
    for (const Slit& slit : slitsInside(pieces)) {
        joins.push_back({"slit " + std::to_string(joins.size() + 1), slit.points});
    }
    return joinPieces(pieces, joins).pieces;
}

TEST(Slits, AreFoundInsideAndCloseByAJoin) {
    const Pieces sheet{slitSheet({{54, 55, 56, 57}})};
    const auto slits = slitsInside(sheet);
    ASSERT_EQ(slits.size(), 1U);
    EXPECT_EQ(slits[0].piece, 0);
    EXPECT_NEAR(slits[0].length, 30, 1e-12);
    const Pieces whole = closed(sheet);
    EXPECT_FALSE(whole[0]->defect);
    EXPECT_TRUE(whole[0]->holes.empty());
    EXPECT_EQ(whole[0]->mesh.V.rows(), 13 * 13);
}

TEST(Slits, ADartIsNone) {
    EXPECT_TRUE(slitsInside({slitSheet({{6, 19, 32, 45}})}).empty());
    EXPECT_TRUE(slitsInside({slitSheet({})}).empty());
}

TEST(Slits, CloseToTheSheetTheyWereMadeIn) {
    // A straight one, one with a corner, and one with three ends.
    const auto before =
        slitSheet({{54, 55, 56, 57}, {80, 81, 94, 107}, {84, 85, 86, 87, 88}, {86, 99, 112}});
    before->file = 2;
    before->reference = Points2(Points2::Zero(before->mesh.V.rows(), 2));
    ASSERT_EQ(loopLengths(*before).size(), 4U);
    std::vector<std::shared_ptr<Piece>> pieces{before};
    closeSlits(pieces);
    ASSERT_EQ(pieces.size(), 1U);
    const Piece& whole = *pieces[0];
    EXPECT_FALSE(whole.defect);
    EXPECT_TRUE(whole.holes.empty());
    EXPECT_EQ(loopLengths(whole).size(), 1U);
    EXPECT_EQ(whole.boundary.size(), 4U * 12);
    EXPECT_EQ(whole.mesh.V.rows(), 13 * 13);
    EXPECT_EQ(whole.mesh.F.rows(), before->mesh.F.rows());
    EXPECT_NEAR(triangleAreas3d(whole.mesh).sum(), triangleAreas3d(before->mesh).sum(), 1e-9);
    EXPECT_EQ(whole.name, before->name);
    EXPECT_EQ(whole.file, 2);
    EXPECT_EQ(whole.sourceVertex.size(), 13U * 13);
    EXPECT_EQ(whole.sourceFace, before->sourceFace);
    EXPECT_FALSE(whole.reference);  // it is open where the piece was
    EXPECT_TRUE(slitsInside({pieces[0]}).empty());
}

TEST(Slits, ClosedLeaveADartOpenAndPiecesWithoutThemAlone) {
    const std::vector<int> dart{6, 19, 32, 45};
    std::vector<std::shared_ptr<Piece>> pieces{slitSheet({dart}), slitSheet({}),
                                               slitSheet({dart, {106, 107, 108}})};
    for (int k = 0; k < 3; ++k) {  // or the edges of all three lie on each other
        pieces[static_cast<std::size_t>(k)]->mesh.V.col(2).array() += 100 * k;
    }
    const auto before = pieces;
    closeSlits(pieces);
    EXPECT_EQ(pieces[0], before[0]);
    EXPECT_EQ(pieces[1], before[1]);
    EXPECT_NE(pieces[2], before[2]);
    EXPECT_EQ(loopLengths(*before[2]).size(), 2U);
    EXPECT_EQ(loopLengths(*pieces[2]).size(), 1U);
    EXPECT_FALSE(pieces[2]->defect);
    EXPECT_EQ(pieces[2]->mesh.V.rows(), 13 * 13 + 3);
}

TEST(Slits, AreWhatAUvMapLeavesOpenInsideItsIslands) {
    const auto slitsOf = [](const std::filesystem::path& path, bool close = false) {
        Progress progress;
        LoadOptions options;
        options.split = SplitMode::Uv;
        options.closeSlits = close;
        const auto garment = loadGarment({path}, options, progress);
        return garment ? static_cast<int>(slitsInside(garment->pieces).size()) : -1;
    };
    const auto suit = test::sharedFile("garments/suit_mh.obj");
    const auto polo = test::sharedFile("garments/polo.obj");
    TOILE_NEEDS_SHARED(suit);
    TOILE_NEEDS_SHARED(polo);
    EXPECT_GT(slitsOf(suit), 100);
    EXPECT_EQ(slitsOf(suit, true), 0);
    EXPECT_EQ(slitsOf(polo), 0);  // its tubes are open from end to end
}

}  // namespace
}  // namespace toile
