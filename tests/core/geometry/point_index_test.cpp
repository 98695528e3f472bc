// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/point_index.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace toile {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// What PointIndex finds, by a look at every point.
int firstNear(const Points& points, const Eigen::Vector3d& p, double tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if ((points[i] - p).norm() <= tolerance) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

TEST(PointIndex, FindsWhatALookAtAllPointsFinds) {
    std::mt19937 random(5);
    for (const double size : {4.0, 40.0, 4e9}) {  // in tolerances
        Points points;
        geometry::PointIndex index(points, 1);
        std::uniform_real_distribution<double> coordinate(-size, size);
        for (int i = 0; i < 3000; ++i) {
            const Eigen::Vector3d p(coordinate(random), coordinate(random), coordinate(random));
            const int known = firstNear(points, p, 1);
            const auto count = static_cast<int>(points.size());
            const auto [found, isNew] = index.insert(p);
            EXPECT_EQ(isNew, known < 0);
            EXPECT_EQ(found, known < 0 ? count : known);
            EXPECT_EQ(static_cast<int>(points.size()), count + (known < 0 ? 1 : 0));
        }
    }
}

TEST(PointIndex, WithoutToleranceFindsTheSameBits) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Points points;
    geometry::PointIndex index(points);
    EXPECT_EQ(index.insert({0, 1, 2}), std::pair(0, true));
    EXPECT_EQ(index.insert({-0.0, 1, 2}), std::pair(0, false));
    EXPECT_FALSE(std::signbit(points[0].x()));
    EXPECT_EQ(index.insert({0, 1, std::nextafter(2, 3)}), std::pair(1, true));
    EXPECT_EQ(index.insert({5e-324, 1, 2}), std::pair(2, true));
    EXPECT_EQ(index.insert({kNone, 1, 2}), std::pair(3, true));
    EXPECT_EQ(index.insert({kNone, 1, 2}), std::pair(3, false));
    points.emplace_back(7, 7, 7);  // by somebody else
    EXPECT_EQ(index.insert({8, 8, 8}), std::pair(5, true));
    for (int i = 0; i < 5000; ++i) {
        EXPECT_EQ(index.insert(Eigen::Vector3d(i, i + 0.5, 0)).first, 6 + i);
    }
    EXPECT_EQ(index.insert({4, 4.5, 0}), std::pair(10, false));
    EXPECT_EQ(index.insert({8, 8, 8}), std::pair(5, false));
}

TEST(PointIndex, TakesCoordinatesOfAnySize) {
    constexpr double kMax = std::numeric_limits<double>::max();
    Points points;
    geometry::PointIndex index(points, 1e-9);
    const Points far{{0, 0, 0}, {kMax, 0, 0}, {-kMax, 0, 0}, {1e30, 1e30, 0}};
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(index.insert(far[static_cast<std::size_t>(i)]), std::pair(i, true));
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(index.insert(far[static_cast<std::size_t>(i)]), std::pair(i, false));
    }
}

}  // namespace
}  // namespace toile
