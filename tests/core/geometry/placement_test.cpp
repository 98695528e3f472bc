// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/placement.h"

#include <gtest/gtest.h>

namespace toile::geometry {
namespace {

const Polygon kShape = (Polygon(5, 2) << 0, 0, 30, 0, 34, 12, 20, 25, -3, 9).finished();

TEST(Placement, IsUndoneByItsInverse) {
    for (const bool mirrored : {false, true}) {
        const Placement placement{{12, -7}, 0.8, mirrored};
        const Polygon back = placement.inverse().appliedToRows(placement.appliedToRows(kShape));
        EXPECT_LT((back - kShape).norm(), 1e-12);
    }
}

TEST(Placement, AFitFindsTheMotionOfAnyPoints) {
    for (const bool mirrored : {false, true}) {
        for (double turn = -3; turn < 3; turn += 0.7) {
            const Placement placement{{-40, 8}, turn, mirrored};
            const Placement found = fitMotion(kShape, placement.appliedToRows(kShape), mirrored);
            EXPECT_NEAR(found.turn, turn, 1e-12);
            EXPECT_LT((found.offset - placement.offset).norm(), 1e-11);
        }
    }
}

TEST(Placement, AFitFollowsTheWeights) {
    Polygon moved = kShape.rowwise() + Eigen::RowVector2d(5, 5);
    moved.row(4) << 500, 500;
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(5);
    weights[4] = 0;
    const Placement found = fitMotion(kShape, moved, false, weights);
    EXPECT_NEAR(found.turn, 0, 1e-12);
    EXPECT_LT((found.offset - Eigen::Vector2d(5, 5)).norm(), 1e-12);
    EXPECT_EQ(fitMotion(Polygon(0, 2), Polygon(0, 2)), Placement());
}

}  // namespace
}  // namespace toile::geometry
