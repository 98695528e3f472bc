// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/best_grain.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/support/growth.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

const Fabric kWoven = fabricPresets().front();

/// Of two directions of a line.
double apart(double a, double b) {
    return std::abs(std::remainder(a - b, kPi));
}

/// A flat piece and what it must stretch to: by `strain` along `direction`.
std::pair<MeshArrays, Points2> stretched(double direction, double strain, int side = 6) {
    MeshArrays mesh = test::planeGrid(side, side, 10);
    const Points2 Q = mesh.V.leftCols<2>();
    const Eigen::Vector2d d(std::cos(direction), std::sin(direction));
    const Eigen::Matrix2d map = Eigen::Matrix2d::Identity() + strain * d * d.transpose();
    mesh.V.leftCols<2>() = (Q * map.transpose()).eval();
    return {mesh, Q};
}

TEST(BestGrain, LeavesTheStretchToTheDirectionThatAllowsMost) {
    // 6 % along one line: a woven gives that on the bias alone.
    for (const double direction : {0.0, 0.3, 1.1, 2.6}) {
        const auto [mesh, Q] = stretched(direction, 0.06);
        const auto best = bestGrain(mesh, Q, kWoven);
        ASSERT_TRUE(best);
        EXPECT_LT(std::abs(apart(*best, direction) - kPi / 4), 0.12) << direction;
    }
    // Jersey gives way most across the grain.
    const Fabric& jersey = *fabricPreset("jersey");
    const auto [mesh, Q] = stretched(0.4, 0.33);
    const auto best = bestGrain(mesh, Q, jersey);
    ASSERT_TRUE(best);
    EXPECT_LT(apart(*best, 0.4 + kPi / 2), 0.1);
}

TEST(BestGrain, TurnsWithThePiece) {
    const auto [mesh, Q] = stretched(0.7, 0.05);
    const auto before = bestGrain(mesh, Q, kWoven);
    for (const double turn : {0.5, 1.9}) {
        const Points2 turned = Q * Eigen::Rotation2Dd(turn).toRotationMatrix().transpose();
        const auto after = bestGrain(mesh, turned, kWoven);
        ASSERT_TRUE(before && after);
        const double a = grainCost(mesh, turned, kWoven, *after);
        const double b = grainCost(mesh, Q, kWoven, *before);
        EXPECT_NEAR(a, b, 1e-6 * b);
    }
}

TEST(BestGrain, IsAsGoodAsTheBestOfAllAngles) {
    // A cap pressed flat: strained differently everywhere.
    MeshArrays mesh = test::sphericalCap(12, 100, 0.9);
    Points2 Q(mesh.V.rows(), 2);
    Q.col(0) = 1.1 * mesh.V.col(0);
    Q.col(1) = mesh.V.col(2) + 0.2 * mesh.V.col(0);
    for (const Fabric& fabric : fabricPresets()) {
        const auto best = bestGrain(mesh, Q, fabric);
        ASSERT_TRUE(best) << fabric.id;
        double least = HUGE_VAL, most = 0;
        for (int k = 0; k < 360; ++k) {
            const double cost = grainCost(mesh, Q, fabric, kPi * k / 360);
            least = std::min(least, cost);
            most = std::max(most, cost);
        }
        const double own = grainCost(mesh, Q, fabric, *best);
        EXPECT_LE(own - least, 0.01 * (most - least)) << fabric.id;
        EXPECT_GE(*best, 0);
        EXPECT_LT(*best, kPi);
    }
}

TEST(BestGrain, HasNoneWhereAllDirectionsAreAlike) {
    const MeshArrays mesh = test::planeGrid(4, 4, 10);
    const Points2 Q = mesh.V.leftCols<2>();
    EXPECT_FALSE(bestGrain(mesh, Q, kWoven));
    const Fabric alike{"custom", {-0.01, 0.02}, {-0.01, 0.02}, {-0.01, 0.02}};
    const Points2 smaller = 0.9 * Q;
    EXPECT_FALSE(bestGrain(mesh, smaller, alike));
    EXPECT_FALSE(bestGrain(MeshArrays{Points3(0, 3), Triangles(0, 3)}, Points2(0, 2), kWoven));
    EXPECT_FALSE(bestGrain(mesh, Points2(Points2::Constant(Q.rows(), 2, std::nan(""))), kWoven));
}

TEST(BestGrainClock, LooksAtEveryTriangleOnceAndNotOncePerAngle) {
    const auto [mesh, Q] = stretched(0.5, 0.05, 300);
    const double one = test::quickest([&mesh = mesh, &Q = Q] { grainCost(mesh, Q, kWoven, 0.5); });
    const double all = test::quickest([&mesh = mesh, &Q = Q] { bestGrain(mesh, Q, kWoven); });
    EXPECT_LT(all, 12 * one);  // about twice; over eighty angles tried on the triangles: 40 times
}

}  // namespace
}  // namespace toile
