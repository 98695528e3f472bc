// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/vertices_around.h"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "core/geometry/shortest_paths.h"
#include "tests/core/sew/cloth_shapes.h"

namespace toile::sew {
namespace {

using Vertices = std::vector<int>;

Neighbours linked(int count, const std::vector<std::tuple<int, int, double>>& edges) {
    Neighbours neighbours(static_cast<std::size_t>(count));
    for (const auto& [a, b, length] : edges) {
        neighbours[a].emplace_back(b, length);
        neighbours[b].emplace_back(a, length);
    }
    return neighbours;
}

TEST(VerticesAround, TheShortestWayCountsAndNotThatOfFewestEdges) {
    // To 2 by 1 in two long edges, by 3 and 4 in three short ones; 5 and 6 lie beyond it.
    const Neighbours neighbours = linked(
        7, {{0, 1, 5}, {1, 2, 5}, {0, 3, 0.5}, {3, 4, 0.5}, {4, 2, 0.5}, {2, 5, 1}, {5, 6, 1}});
    VerticesAround around(neighbours, 2, 3);
    EXPECT_EQ(around.of({0}), (Vertices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(around.of({0, 0, 6}), (Vertices{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(around.of({0}), (Vertices{0, 1, 2, 3, 4, 5}));  // whatever was asked before
    VerticesAround near(neighbours, 0, 1);
    EXPECT_EQ(near.of({0}), (Vertices{0, 3, 4}));
}

TEST(VerticesAround, IsWithinItsRingsOrItsWayAndNothingElse) {
    CutCloth cut = test::tubeCloth(20, 16, 20, 60);
    cut.V = test::shaken(cut.V, 2, 7);
    cut.Q.col(0) =
        cut.Q.col(0).array().square() / 60;  // short edges on one side, long on the other
    const Cloth cloth = sewTogether(cut);
    const Neighbours neighbours = neighboursOf(cloth);
    std::vector<std::pair<int, int>> pairs;
    std::vector<double> lengths;
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
        for (const auto& [other, length] : neighbours[v]) {
            pairs.emplace_back(static_cast<int>(v), other);
            lengths.push_back(length);
        }
    }
    geometry::VertexPairs edges(static_cast<Eigen::Index>(pairs.size()), 2);
    for (std::size_t e = 0; e < pairs.size(); ++e) {
        edges.row(static_cast<Eigen::Index>(e)) << pairs[e].first, pairs[e].second;
    }
    const std::vector<double> each(lengths.size(), 1);
    const int count = static_cast<int>(neighbours.size());
    constexpr double kFar = 9;
    VerticesAround around(neighbours, 2, kFar);
    for (const int seed : {0, count / 3, count / 2, count - 1}) {
        const auto ways = geometry::shortestForest(edges, count, lengths, {{seed}});
        const auto rings = geometry::shortestForest(edges, count, each, {{seed}});
        const Vertices found = around.of({seed});
        EXPECT_TRUE(std::ranges::is_sorted(found));
        int beyondRings = 0;
        for (int v = 0; v < count; ++v) {
            EXPECT_EQ(std::ranges::binary_search(found, v),
                      rings.distance[v] <= 2 || ways.distance[v] <= kFar)
                << seed << " " << v;
            beyondRings += static_cast<int>(rings.distance[v] > 2 && ways.distance[v] <= kFar);
        }
        EXPECT_LT(found.size(), neighbours.size());
        EXPECT_GE(beyondRings, seed == 0 ? 1 : 0);
    }
}

}  // namespace
}  // namespace toile::sew
