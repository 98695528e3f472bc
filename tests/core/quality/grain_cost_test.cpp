// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/quality/metric_tensor.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

const Fabric kWoven = *fabricPreset("woven");

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

/// The direction of least cost, to a degree.
double cheapest(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric) {
    double least = HUGE_VAL, best = 0;
    for (int k = 0; k < 180; ++k) {
        const double cost = grainCost(mesh, Q, fabric, kPi * k / 180);
        if (cost < least) {
            least = cost;
            best = kPi * k / 180;
        }
    }
    return best;
}

TEST(GrainCost, IsLeastWhereTheStretchLiesTheWayThatAllowsMost) {
    // 6 % along one line: a woven gives that on the bias alone.
    for (const double direction : {0.0, 0.3, 1.1, 2.6}) {
        const auto [mesh, Q] = stretched(direction, 0.06);
        EXPECT_LT(std::abs(apart(cheapest(mesh, Q, kWoven), direction) - kPi / 4), 0.12);
    }
    // Jersey gives way most across the grain.
    const auto [mesh, Q] = stretched(0.4, 0.33);
    EXPECT_LT(apart(cheapest(mesh, Q, *fabricPreset("jersey")), 0.4 + kPi / 2), 0.1);
}

TEST(GrainCost, TurnsWithThePiece) {
    const auto [mesh, Q] = stretched(0.7, 0.05);
    for (const double turn : {0.5, 1.9}) {
        const Points2 turned = Q * Eigen::Rotation2Dd(turn).toRotationMatrix().transpose();
        for (const double angle : {0.0, 0.9, 2.2}) {
            const double before = grainCost(mesh, Q, kWoven, angle);
            EXPECT_NEAR(grainCost(mesh, turned, kWoven, angle + turn), before, 1e-9 * before);
        }
    }
}

TEST(GrainCost, IsTheSameBothWaysAlongALine) {
    const auto [mesh, Q] = stretched(0.7, 0.05);
    const double cost = grainCost(mesh, Q, kWoven, 0.4);
    EXPECT_NEAR(grainCost(mesh, Q, kWoven, 0.4 + kPi), cost, 1e-12 * cost);
}

TEST(GrainCost, IsNothingWhereNothingIsStrainedOrCanBeMeasured) {
    const MeshArrays mesh = test::planeGrid(4, 4, 10);
    const Points2 Q = mesh.V.leftCols<2>();
    EXPECT_NEAR(grainCost(mesh, Q, kWoven, 0.3), 0, 1e-15);
    EXPECT_EQ(grainCost(MeshArrays{Points3(0, 3), Triangles(0, 3)}, Points2(0, 2), kWoven, 0), 0);
    EXPECT_EQ(grainCost(mesh, Points2(Points2::Constant(Q.rows(), 2, std::nan(""))), kWoven, 0), 0);
}

}  // namespace
}  // namespace toile
