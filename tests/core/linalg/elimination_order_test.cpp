// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "core/linalg/block_matrix.h"
#include "core/linalg/landmark_distances.h"

namespace toile {
namespace {

CouplingGraph graphOf(int size, const std::vector<std::pair<int, int>>& edges) {
    SymmetricBuilder builder(size);
    for (const auto& [i, j] : edges) {
        builder.add(i, j, -1);
    }
    return couplings(builder.build());
}

/// A square grid with one diagonal in each cell, n x n vertices, from vertex `first` on.
std::vector<std::pair<int, int>> gridEdges(int n, int first = 0) {
    std::vector<std::pair<int, int>> edges;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            const int v = first + row * n + column;
            if (column + 1 < n) {
                edges.emplace_back(v, v + 1);
            }
            if (row + 1 < n) {
                edges.emplace_back(v, v + n);
            }
            if (column + 1 < n && row + 1 < n) {
                edges.emplace_back(v, v + n + 1);
            }
        }
    }
    return edges;
}

void expectPermutation(std::vector<int> order, int size) {
    ASSERT_EQ(static_cast<int>(order.size()), size);
    std::sort(order.begin(), order.end());
    for (int i = 0; i < size; ++i) {
        EXPECT_EQ(order[i], i);
    }
}

/// Entries below the diagonal of the factor, by playing the elimination.
std::size_t fill(const CouplingGraph& graph, const std::vector<int>& order) {
    std::vector<std::set<int>> neighbours(order.size());
    for (int v = 0; v < graph.size(); ++v) {
        neighbours[v].insert(graph.neighbour.begin() + graph.start[v],
                             graph.neighbour.begin() + graph.start[v + 1]);
    }
    std::size_t entries = 0;
    for (const int v : order) {
        entries += neighbours[v].size();
        for (const int w : neighbours[v]) {
            neighbours[w].insert(neighbours[v].begin(), neighbours[v].end());
            neighbours[w].erase(v);
            neighbours[w].erase(w);
        }
    }
    return entries;
}

TEST(Couplings, AreThoseOfTheMatrixBothWays) {
    const CouplingGraph graph = graphOf(4, {{0, 2}, {2, 1}, {3, 2}});
    EXPECT_EQ(graph.start, (std::vector<int>{0, 1, 2, 5, 6}));
    EXPECT_EQ(graph.neighbour[0], 2);
    EXPECT_EQ((std::multiset<int>(graph.neighbour.begin() + 2, graph.neighbour.begin() + 5)),
              (std::multiset<int>{0, 1, 3}));
}

TEST(LandmarkDistances, ChangeByOneAtMostAlongEdgesAndVanishOnceInEachPart) {
    auto edges = gridEdges(12);
    const auto second = gridEdges(7, 144);
    edges.insert(edges.end(), second.begin(), second.end());
    const CouplingGraph graph = graphOf(144 + 49, edges);
    std::vector<int> all(193);
    std::iota(all.begin(), all.end(), 0);
    std::vector<LandmarkDistances> distances(193);
    LandmarkSurvey(graph).measure(all, std::vector<char>(193, 0), distances);
    for (int k = 0; k < kLandmarks; ++k) {
        for (const auto& [i, j] : edges) {
            EXPECT_LE(std::abs(distances[i][k] - distances[j][k]), 1);
        }
        const auto isLandmark = [k](const LandmarkDistances& d) { return d[k] == 0; };
        EXPECT_EQ(std::count_if(distances.begin(), distances.begin() + 144, isLandmark), 1);
        EXPECT_EQ(std::count_if(distances.begin() + 144, distances.end(), isLandmark), 1);
    }
}

TEST(NestedDissection, IsAPermutationAlsoOfSmallAndOfDividedGraphs) {
    expectPermutation(nestedDissection(graphOf(1, {})), 1);
    expectPermutation(nestedDissection(graphOf(20, {})), 20);
    expectPermutation(nestedDissection(graphOf(25, gridEdges(5))), 25);
    auto edges = gridEdges(20);
    const auto second = gridEdges(15, 400);
    edges.insert(edges.end(), second.begin(), second.end());
    expectPermutation(nestedDissection(graphOf(630, edges)), 630);
}

TEST(NestedDissection, KeepsTheFactorOfAGridSmall) {
    // Of the order of n log2 n entries, where row by row takes n^1.5.
    const int side = 40;
    const int n = side * side;
    const CouplingGraph graph = graphOf(n, gridEdges(side));
    const std::size_t entries = fill(graph, nestedDissection(graph));
    EXPECT_LT(static_cast<double>(entries), 2.0 * n * std::log2(n));
    std::vector<int> rows(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        rows[i] = i;
    }
    EXPECT_LT(2 * entries, fill(graph, rows));
}

TEST(NestedDissection, IsTheSameEachTime) {
    const CouplingGraph graph = graphOf(900, gridEdges(30));
    EXPECT_EQ(nestedDissection(graph).order, nestedDissection(graph));
}

TEST(NestedDissection, LeavesGraphsWithoutLevelsAlone) {
    // Every vertex beside every other: there is no separator.
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < i; ++j) {
            edges.emplace_back(i, j);
        }
    }
    EXPECT_TRUE(nestedDissection(graphOf(60, edges)).empty());
}

TEST(NestedDissection, TakesAVertexBesideAllOthersLast) {
    std::vector<std::pair<int, int>> edges;
    for (int i = 1; i < 20; ++i) {
        edges.emplace_back(0, i);
    }
    const auto order = nestedDissection(graphOf(20, edges));
    expectPermutation(order, 20);
    EXPECT_GE(std::find(order.begin(), order.end(), 0) - order.begin(), 18);
}

TEST(EliminationOrder, IsFoundForLargeSystemsOnly) {
    const auto systemOf = [](int side) -> SymmetricMatrix {
        SymmetricBuilder builder(side * side);
        for (const auto& [i, j] : gridEdges(side)) {
            builder.add(i, j, -1);
        }
        return builder.build();
    };
    EXPECT_TRUE(eliminationOrder(systemOf(20)).empty());
    expectPermutation(eliminationOrder(systemOf(150)), 150 * 150);
}

TEST(EliminationOrder, KeepsPairsOfUnknownsTogether) {
    const auto systemOf = [](int side) -> SymmetricMatrix {
        const auto edges = gridEdges(side);
        std::vector<std::pair<int, int>> sorted;
        for (const auto& [i, j] : edges) {
            sorted.emplace_back(std::min(i, j), std::max(i, j));
        }
        std::sort(sorted.begin(), sorted.end());
        VertexPairs pairs(static_cast<Eigen::Index>(sorted.size()), 2);
        for (std::size_t e = 0; e < sorted.size(); ++e) {
            pairs.row(static_cast<Eigen::Index>(e)) << sorted[e].first, sorted[e].second;
        }
        return BlockMatrix(pairs, side * side).matrix();
    };
    EXPECT_TRUE(comesInPairs(systemOf(6)));
    SymmetricBuilder single(4);
    single.add(0, 1, -1);
    single.add(1, 2, -1);
    EXPECT_FALSE(comesInPairs(single.build()));
    const auto order = eliminationOrder(systemOf(230));
    expectPermutation(order, 2 * 230 * 230);
    for (std::size_t k = 0; k < order.size(); k += 2) {
        ASSERT_EQ(order[k] % 2, 0);
        ASSERT_EQ(order[k + 1], order[k] + 1);
    }
}

}  // namespace
}  // namespace toile
