// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/identify.h"

#include <set>

#include <gtest/gtest.h>

#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

constexpr const char* kTwoAlike =
    "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 4 5 6\n";

std::set<PieceId> idsOf(const Garment& garment) {
    std::set<PieceId> ids;
    for (const auto& piece : garment.pieces) {
        ids.insert(piece->id);
    }
    return ids;
}

TEST(Identify, EqualPiecesAndAFileOpenedTwiceHaveIdsOfTheirOwn) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("a.obj", kTwoAlike);
    Progress progress;
    const auto twice = loadGarment({path, path}, {}, progress);
    ASSERT_TRUE(twice);
    EXPECT_EQ(idsOf(*twice).size(), 4U);
    const auto again = loadGarment({folder.write("b.obj", kTwoAlike)}, {}, progress);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->pieces[0]->id, twice->pieces[0]->id);  // by content, not by path
    EXPECT_EQ(again->pieces[1]->id, twice->pieces[1]->id);
}

TEST(Identify, WhatAFileSaysTwiceGivesNoTwoPiecesOneId) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("a.obj", kTwoAlike);
    Progress progress;
    LoadOptions options;
    const auto first = loadGarment({path}, options, progress);
    ASSERT_TRUE(first);
    options.known = knownPieces(*first);
    for (KnownPiece& piece : options.known) {
        piece.id = {77};
    }
    const auto garment = loadGarment({path}, options, progress);
    ASSERT_TRUE(garment);
    EXPECT_EQ(idsOf(*garment).size(), 2U);
    std::vector<UserCut> cuts{
        {"a", {}, {}, false, {5}}, {"b", {}, {}, false, {5}}, {"c", {}, {}}, {"d", {}, {}}};
    giveIds(cuts);
    std::set<CutId> ids;
    for (const UserCut& cut : cuts) {
        EXPECT_TRUE(cut.id);
        ids.insert(cut.id);
    }
    EXPECT_EQ(ids.size(), 4U);
}

TEST(Identify, ARimBeginsAtItsLeastVertexWhateverTheNumbers) {
    const MeshArrays mesh = test::planeGrid(4, 3, 10);
    Piece piece = makePiece("a", mesh);
    test::identify(piece, 1);
    const test::Renumbered other = test::renumber(mesh, 5);
    Piece renumbered = makePiece("a", other.mesh);
    test::identify(renumbered, 1);
    ASSERT_EQ(piece.origins.size(), renumbered.origins.size());
    for (const EdgeOrigin& edge : piece.origins) {
        const EdgeOrigin* same = originAt(renumbered.origins, other.newIndex[edge.tail]);
        ASSERT_TRUE(same);
        EXPECT_EQ(same->head, other.newIndex[edge.head]);
        EXPECT_EQ(same->line, edge.line);
        EXPECT_EQ(same->from, edge.from);
        EXPECT_EQ(same->to, edge.to);
    }
}

TEST(Identify, NamesStayUniqueWhereTheFileHasChanged) {
    const test::TemporaryFolder folder;
    const std::string square = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\n";
    const auto path = folder.write("a.obj", square + "o x\nf 1 2 3 4\n");
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    options.split = SplitMode::Objects;
    options.seams.cuts = {{"cut", UserCut::Kind::Path, {{0, 5, 0}, {10, 5, 0}}}};
    Progress progress;
    const auto before = loadGarment({path}, options, progress);
    ASSERT_TRUE(before);
    ASSERT_EQ(before->pieces.size(), 2U);
    folder.write("a.obj",
                 square + "o x\nf 1 2 3 4\nv 50 0 0\nv 60 0 0\nv 60 9 0\n" + "o x 1\nf 5 6 7\n");
    options.known = knownPieces(*before);
    const auto after = makeGarment({*readFiles({path}, progress), options}, progress, {}, &*before);
    ASSERT_TRUE(after);
    std::set<std::string> names;
    for (const auto& piece : after->pieces) {
        names.insert(piece->name);
    }
    EXPECT_EQ(names.size(), 3U);
}

}  // namespace
}  // namespace toile
