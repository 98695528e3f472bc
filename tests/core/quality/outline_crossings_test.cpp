// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/outline_crossings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/geometry/segment_pairs.h"
#include "core/quality/measures.h"
#include "tests/core/support/growth.h"

namespace toile {
namespace {

std::vector<int> loop(Eigen::Index n) {
    std::vector<int> indices(static_cast<std::size_t>(n));
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

/// Every pair, solved as two lines.
int bruteForce(const Points2& Q) {
    const int n = static_cast<int>(Q.rows());
    int count = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = i + 2; j < n; ++j) {
            if ((j + 1) % n == i) {
                continue;
            }
            Eigen::Matrix2d M;
            M.col(0) = (Q.row((i + 1) % n) - Q.row(i)).transpose();
            M.col(1) = (Q.row(j) - Q.row((j + 1) % n)).transpose();
            const Eigen::Vector2d s =
                M.inverse() * Eigen::Vector2d((Q.row(j) - Q.row(i)).transpose());
            count += s.minCoeff() > 0 && s.maxCoeff() < 1 ? 1 : 0;
        }
    }
    return count;
}

TEST(OutlineCrossings, ASquareHasNoneAndABowTieOne) {
    Points2 Q(4, 2);
    Q << 0, 0, 1, 0, 1, 1, 0, 1;
    EXPECT_EQ(outlineCrossings(Q, loop(4)), 0);
    Q << 0, 0, 1, 1, 1, 0, 0, 1;
    EXPECT_EQ(outlineCrossings(Q, loop(4)), 1);
}

TEST(OutlineCrossings, AgreesWithBruteForceOnRandomPolygons) {
    std::mt19937 random(5);
    for (const int n : {4, 5, 9, 14, 19, 30, 45, 60, 150, 600}) {
        Points2 Q(n, 2);
        for (int i = 0; i < n; ++i) {
            Q.row(i) << random() / 4294967296.0, 3 * (random() / 4294967296.0);
        }
        EXPECT_EQ(outlineCrossings(Q, loop(n)), bruteForce(Q)) << n;
    }
}

TEST(OutlineCrossings, TheTwoSidesOfASlitDoNotCross) {
    // Down one side of the slit and up the other, with rounding between them.
    Points2 Q(11, 2);
    Q << 0, 0, 10, 0, 10, 10, 5, 10, 5 + 1e-14, 8, 5 - 1e-14, 6, 5, 4, 5 + 2e-14, 6, 5 - 2e-14, 8,
        5, 10, 0, 10;
    EXPECT_EQ(outlineCrossings(Q, loop(11)), 0);
}

TEST(OutlineCrossings, TouchingIsNoCrossing) {
    Points2 Q(6, 2);
    Q << 0, 0, 4, 0, 4, 3, 2, 0, 0, 3, -1, 1;  // a corner rests on the bottom edge
    EXPECT_EQ(outlineCrossings(Q, loop(6)), 0);
}

TEST(OutlineCrossings, NamesEdgesAndPlace) {
    Points2 Q(4, 2);
    Q << 0, 0, 4, 4, 4, 0, 0, 4;
    const auto crossings = findOutlineCrossings(Q, loop(4));
    ASSERT_EQ(crossings.size(), 1);
    EXPECT_EQ(crossings[0].first, 0);
    EXPECT_EQ(crossings[0].second, 2);
    EXPECT_EQ(crossings[0].place, Eigen::RowVector2d(2, 2));
    EXPECT_FALSE(outlineIsSimple(Q, loop(4)));
}

TEST(OutlineCrossings, PassingThroughACornerOrAnEdgeCrosses) {
    Points2 Q(6, 2);
    Q << 0, 0, 4, 0, 4, 3, 2, 0, 0, -3, -1, 1;  // from above through (2, 0) to below
    const auto throughEdge = findOutlineCrossings(Q, loop(6));
    ASSERT_EQ(throughEdge.size(), 1);
    EXPECT_EQ(throughEdge[0].first, 0);
    EXPECT_EQ(throughEdge[0].second, 3);
    EXPECT_EQ(throughEdge[0].place, Eigen::RowVector2d(2, 0));
    // An eight whose two strokes meet in corners of both.
    Points2 eight(6, 2);
    eight << 0, 0, -1, -1, 1, -1, 0, 0, -1, 1, 1, 1;
    EXPECT_EQ(outlineCrossings(eight, loop(6)), 1);
    // The same corners without passing: two drops hanging on one point.
    Points2 drops(6, 2);
    drops << 0, 0, -1, -1, 1, -1, 0, 0, 1, 1, -1, 1;
    EXPECT_EQ(outlineCrossings(drops, loop(6)), 0);
}

/// The outline of a flat ring sector that turns `degrees`, a corner every ten.
Points2 ringSector(int degrees) {
    const int steps = degrees / 10;
    Points2 Q(2 * (steps + 1), 2);
    for (int k = 0; k <= steps; ++k) {
        const double angle = k % 36 * 10 * std::numbers::pi / 180;  // equal bytes every turn
        const Eigen::RowVector2d direction(std::cos(angle), std::sin(angle));
        Q.row(k) = 2 * direction;
        Q.row(Q.rows() - 1 - k) = direction;
    }
    return Q;
}

TEST(OutlineCrossings, StretchesOnEachOtherCrossWhereTheClothIsOnTheSameSide) {
    EXPECT_EQ(outlineCrossings(ringSector(350), loop(72)), 0);
    EXPECT_EQ(outlineCrossings(ringSector(360), loop(74)), 0);  // its ends lie on each other
    EXPECT_GE(outlineCrossings(ringSector(400), loop(82)), 8);
    EXPECT_GE(outlineCrossings(ringSector(720), loop(146)), 72);
}

TEST(OutlineCrossings, NeitherPlaceNorDirectionNorStartMatters) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        // Few whole coordinates: corners on edges, corners on corners, edges on edges.
        const int n = 4 + static_cast<int>(random() % 12);
        Points2 Q(n, 2);
        for (int i = 0; i < n; ++i) {
            do {
                Q.row(i) << static_cast<double>(random() % 6), static_cast<double>(random() % 6);
            } while (i > 0 && Q.row(i) == Q.row(i - 1));
        }
        if (Q.row(0) == Q.row(n - 1)) {
            continue;
        }
        const int count = outlineCrossings(Q, loop(n));
        EXPECT_EQ(outlineIsSimple(Q, loop(n)), count == 0);
        const auto all = findOutlineCrossings(Q, loop(n));
        EXPECT_EQ(crossingsFrom(Q, loop(n), n - 3, n * n),
                  std::ranges::count_if(all, [n](const auto& c) { return c.second >= n - 3; }));
        Points2 moved = Q;
        moved.rowwise() += Eigen::RowVector2d(128, -64);
        EXPECT_EQ(outlineCrossings(moved, loop(n)), count);
        std::vector<int> other = loop(n);
        std::rotate(other.begin(), other.begin() + n / 3, other.end());
        EXPECT_EQ(outlineCrossings(Q, other), count);
        std::reverse(other.begin(), other.end());
        EXPECT_EQ(outlineCrossings(Q, other), count);
    }
}

/// How many pairs of edges the search looks at, all in all.
double pairsLookedAt(const Points2& Q) {
    std::vector<geometry::Segment2> edges;
    for (Eigen::Index i = 0; i < Q.rows(); ++i) {
        edges.push_back({Q.row(i), Q.row((i + 1) % Q.rows())});
    }
    double pairs = 0;
    geometry::visitSegmentPairs(
        edges, 0, [&pairs](int, int, const geometry::PlaneCell&) { return ++pairs > 0; });
    return pairs;
}

Eigen::RowVector2d towards(int k, int count) {
    const double angle = 2 * std::numbers::pi * k / count;
    return {std::cos(angle), std::sin(angle)};
}

/// Forty turns, and back.
Points2 spiral(int n) {
    const int half = n / 2;
    Points2 Q(n, 2);
    for (int k = 0; k < half; ++k) {
        const double angle = 2 * std::numbers::pi * 40 * k / half;
        Q.row(k) = (1 + angle) * towards(40 * k, half);
        Q.row(n - 1 - k) = (1 + angle + 3) * towards(40 * k, half);
    }
    return Q;
}

Points2 comb(int n, double slant) {
    const int teeth = n / 2 - 1;
    Points2 Q(2 * teeth + 2, 2);
    for (int k = 0; k < teeth; ++k) {
        Q.row(2 * k) << k, 0;
        Q.row(2 * k + 1) << k + 0.5, 40000;
    }
    Q.row(2 * teeth) << teeth, -10;
    Q.row(2 * teeth + 1) << 0, -10;
    Eigen::Matrix2d turn;
    turn << std::cos(slant), std::sin(slant), -std::sin(slant), std::cos(slant);
    return Q * turn;
}

/// Spikes that almost meet in the middle.
Points2 star(int n) {
    Points2 Q(n, 2);
    for (int k = 0; k < n; ++k) {
        Q.row(k) = (k % 2 == 0 ? 1e-3 : 1.0) * towards(k, n);
    }
    return Q;
}

/// Nearly all edges in a corner of the outline.
Points2 fineDetail(int n) {
    Points2 Q(n, 2);
    for (int k = 0; k < n; ++k) {
        Q.row(k) = (1 + 0.1 * (k % 2)) * towards(k, n);
    }
    Q.row(0) << 1e4, -1e4;
    Q.row(1) << 1e4, 1e4;
    Q.row(2) *= 1.1;  // the way to the far corners begins outside
    return Q;
}

/// Two sides that lie on each other.
Points2 slit(int n) {
    Points2 Q(n, 2);
    for (int k = 0; k < n; ++k) {
        Q.row(k) << std::min(k, n - k), 0;
    }
    Q.row(0) << -1, -1;
    Q.row(n - 1) << -1, 1;
    return Q;
}

struct Large {
    const char* name;
    Points2 (*of)(int edges);
    double growth;  ///< of the pairs looked at, at most, where there are four times the edges
};

class LargeOutlines : public testing::TestWithParam<Large> {};

TEST_P(LargeOutlines, AreNotQuadratic) {
    const Points2 some = GetParam().of(6000), more = GetParam().of(24000);
    EXPECT_EQ(outlineCrossings(more, loop(more.rows())), 0);
    EXPECT_LE(pairsLookedAt(more), GetParam().growth * pairsLookedAt(some));
    EXPECT_LE(pairsLookedAt(some), 3e5);  // of 18 million
}

INSTANTIATE_TEST_SUITE_P(
    OutlineCrossings, LargeOutlines,
    testing::Values(Large{"spiral", spiral, 5}, Large{"star", star, 5},
                    Large{"detail", fineDetail, 6}, Large{"slit", slit, 5},
                    Large{"comb", [](int n) { return comb(n, 0); }, 5},
                    Large{"leaningComb", [](int n) { return comb(n, 0.3); }, 5},
                    Large{"fallingComb", [](int n) { return comb(n, 0.7); }, 5}),
    [](const auto& shown) { return std::string(shown.param.name); });

TEST(OutlineCrossingsClock, LargeOutlinesAreNotQuadratic) {
    for (const auto& outline : {spiral, star, fineDetail, slit}) {
        const Points2 some = outline(25000), more = outline(100000);
        EXPECT_LT(test::growth([&] { outlineCrossings(some, loop(some.rows())); },
                               [&] { outlineCrossings(more, loop(more.rows())); }),
                  10);
    }
}

TEST(OutlineCrossings, AStripOfManyTurnsOnEachOtherIsLookedAtOnce) {
    const int turns = 30;
    const Points2 Q = ringSector(turns * 360);
    // A stretch of either rim per ten degrees and pair of turns, and little else.
    const int stretches = 2 * 36 * turns * (turns - 1) / 2;
    const int count = outlineCrossings(Q, loop(Q.rows()));
    EXPECT_GE(count, stretches * 95 / 100);
    EXPECT_LE(count, stretches * 105 / 100);
    EXPECT_FALSE(outlineIsSimple(Q, loop(Q.rows())));
    EXPECT_LE(pairsLookedAt(Q), 40 * stretches);
}

TEST(OutlineCrossings, LongSegmentsOnEachOtherAreNotDividedForNothing) {
    for (const int n : {18, 40, 1000}) {
        for (const double slant : {0.0, 0.3, 0.785398}) {
            Points2 Q(n, 2);  // to and fro
            for (int k = 0; k < n; ++k) {
                Q.row(k) << (k % 2) * 1000 * std::cos(slant), (k % 2) * 1000 * std::sin(slant);
            }
            const int pairs = n * (n - 1) / 2;
            EXPECT_EQ(outlineCrossings(Q, loop(n)), n / 2 * (n / 2 - 1));  // those of one way
            EXPECT_FALSE(outlineIsSimple(Q, loop(n)));
            EXPECT_LE(pairsLookedAt(Q), 6 * pairs);
        }
    }
}

TEST(OutlineCrossings, AScribbleEndsAtTheLimit) {
    std::mt19937 random(1);
    Points2 Q(8000, 2);
    for (int i = 0; i < Q.rows(); ++i) {
        Q.row(i) << random() / 4294967296.0, random() / 4294967296.0;
    }
    EXPECT_EQ(outlineCrossings(Q, loop(Q.rows())), kMaxOutlineCrossings);
    EXPECT_FALSE(outlineIsSimple(Q, loop(Q.rows())));
}

}  // namespace
}  // namespace toile
