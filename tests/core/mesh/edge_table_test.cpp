// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edge_table.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/support/generator.h"
#include "tests/core/support/random_piece.h"

namespace toile {
namespace {

/// The same table from an ordered map.
void expectTableOf(const Triangles& F, int vertexCount) {
    std::map<std::pair<int, int>, std::vector<int>> uses;
    for (int f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            uses[std::minmax({F(f, k), F(f, (k + 1) % 3)})].push_back(3 * f + k);
        }
    }
    const EdgeTable table = buildEdgeTable(F, vertexCount);
    ASSERT_EQ(table.edges.rows(), std::ssize(uses));
    ASSERT_EQ(std::ssize(table.useStart), std::ssize(uses) + 1);
    ASSERT_EQ(std::ssize(table.use), F.size());
    ASSERT_EQ(table.faceEdges.rows(), F.rows());
    EXPECT_EQ(table.useStart.back(), F.size());
    int e = 0;
    for (const auto& [ends, of] : uses) {
        EXPECT_EQ(table.edges(e, 0), ends.first);
        EXPECT_EQ(table.edges(e, 1), ends.second);
        EXPECT_TRUE(std::ranges::equal(table.usesOf(e), of));
        EXPECT_EQ(table.isBorder(e), of.size() == 1);
        for (const int use : of) {
            EXPECT_EQ(table.faceEdges(use / 3, use % 3), e);
        }
        ++e;
    }
}

TEST(EdgeTable, IsThatOfAnOrderedMapForGoodMeshes) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const MeshArrays mesh = test::randomPiece(seed);
        expectTableOf(mesh.F, static_cast<int>(mesh.V.rows()));
    }
}

TEST(EdgeTable, IsThatOfAnOrderedMapForAnyTriangles) {
    test::Generator random(1);
    for (int round = 0; round < 50; ++round) {
        const int vertexCount = random.whole(1, 60);  // few: crowded edges, repeated corners
        Triangles F(random.whole(0, 400), 3);
        for (int c = 0; c < F.size(); ++c) {
            F.data()[c] = random.whole(0, vertexCount - 1);
        }
        expectTableOf(F, vertexCount);
    }
}

TEST(EdgeTable, IsThatOfAnOrderedMapWhereAllMeetInOneVertex) {
    Triangles F(500, 3);
    for (int f = 0; f < F.rows(); ++f) {
        F.row(f) << 0, 1 + (7 * f) % 499, 1 + (7 * f + 7) % 499;
    }
    expectTableOf(F, 500);
}

TEST(EdgeTable, OfNothingIsEmpty) {
    expectTableOf(Triangles(0, 3), 0);
    expectTableOf(Triangles(0, 3), 5);
}

}  // namespace
}  // namespace toile
