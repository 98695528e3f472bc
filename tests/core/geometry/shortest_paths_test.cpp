// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shortest_paths.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace toile {
namespace {

/// A random graph of which some vertices cannot be reached.
geometry::VertexPairs randomEdges(std::mt19937& random, int vertexCount, int edgeCount) {
    geometry::VertexPairs edges(edgeCount, 2);
    for (int e = 0; e < edgeCount; ++e) {
        edges.row(e) << static_cast<int>(random() % vertexCount),
            static_cast<int>(random() % vertexCount);
    }
    return edges;
}

TEST(ShortestForest, IsWhatRepeatedRelaxationFinds) {
    std::mt19937 random(3);
    for (int run = 0; run < 50; ++run) {
        const int n = 30;
        const geometry::VertexPairs edges = randomEdges(random, n, 40);
        std::vector<double> weights(static_cast<std::size_t>(edges.rows()));
        for (double& weight : weights) {
            weight = static_cast<double>(random() % 10);
        }
        std::vector<double> least(n, HUGE_VAL);
        least[0] = least[1] = least[2] = 0;
        for (int round = 0; round < n; ++round) {
            for (int e = 0; e < edges.rows(); ++e) {
                double &a = least[edges(e, 0)], &b = least[edges(e, 1)];
                a = std::min(a, b + weights[e]);
                b = std::min(b, a + weights[e]);
            }
        }
        const geometry::ShortestForest forest =
            geometry::shortestForest(edges, n, weights, {{0, 1}, {2}});
        EXPECT_EQ(forest.distance, least);
        for (int v = 0; v < n; ++v) {
            EXPECT_EQ(forest.source[v] >= 0, std::isfinite(least[v]));
            const std::vector<int> path = forest.pathTo(v, edges);
            EXPECT_EQ(path.back(), v);
            if (forest.source[v] >= 0) {
                EXPECT_EQ(forest.source[v], path.front() == 2 ? 1 : 0);
                EXPECT_LE(path.front(), 2);
            }
        }
    }
}

TEST(ShortestForest, EndsEarlyWhereAsked) {
    geometry::VertexPairs line(3, 2);
    line << 0, 1, 1, 2, 2, 3;
    const geometry::ShortestForest forest = geometry::shortestForest(line, 4, {1, 1, 1}, {{0}}, 1);
    EXPECT_EQ(forest.distance, (std::vector<double>{0, 1, HUGE_VAL, HUGE_VAL}));
    EXPECT_EQ(forest.pathTo(1, line), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace toile
