// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangle_tree.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(TriangleTree, EmptyAndFlatOnesAnswer) {
    int visits = 0;
    const geometry::TriangleTree<3> empty;
    empty.search([](const auto&) { return 0.0; }, [&](std::uint32_t) { ++visits; });
    EXPECT_EQ(visits, 0);
    // All points in one place: a box without extent.
    const float points[9] = {};
    const std::uint32_t one[3] = {0, 1, 2};
    const geometry::TriangleTree<3> dot(points, 3, one);
    dot.search([](const auto&) { return 0.0; }, [&](std::uint32_t) { ++visits; });
    EXPECT_EQ(visits, 1);
}

template <class Scalar>
class TriangleTreeOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleTreeOf, Scalars);

/// However large the coordinates: of the largest no sum is finite.
TYPED_TEST(TriangleTreeOf, MeetsAllBoxesThatHoldAPlace) {
    using Scalar = TypeParam;
    std::mt19937 random(11);
    for (const Scalar size : {Scalar{1}, std::numeric_limits<Scalar>::max()}) {
        std::vector<Scalar> points(900);
        for (Scalar& coordinate : points) {
            coordinate = size * (static_cast<Scalar>(random() % 2001) / 1000 - 1);
        }
        std::vector<std::uint32_t> triangles(900);
        for (std::uint32_t& corner : triangles) {
            corner = static_cast<std::uint32_t>(random() % 300);
        }
        const geometry::TriangleTree<3, Scalar> tree(points.data(), 3, triangles);
        for (std::uint32_t t = 0; t < 300; ++t) {
            const Scalar* at = points.data() + 3 * triangles[3 * t];
            std::set<std::uint32_t> visited;
            tree.search(
                [&](const auto& box) {
                    bool holds = true;
                    for (std::size_t k = 0; k < 3; ++k) {
                        holds = holds && box.low[k] <= at[k] && at[k] <= box.high[k];
                    }
                    return holds ? 0.0 : geometry::TriangleTree<3, Scalar>::kMissed;
                },
                [&](std::uint32_t triangle) { EXPECT_TRUE(visited.insert(triangle).second); });
            EXPECT_TRUE(visited.contains(t));
        }
    }
}

}  // namespace
}  // namespace toile
