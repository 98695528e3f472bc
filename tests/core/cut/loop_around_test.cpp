// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/loop_around.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/cut/cut_along.h"
#include "core/cut/user_cuts.h"
#include "core/mesh/edge_table.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

TEST(LoopAround, GoesOnceAroundATubeThroughThePlace) {
    const test::Surface tube(test::tube(24, 9));
    const double around = 24 * (tube.mesh.V.row(1) - tube.mesh.V.row(0)).norm();
    for (const int face : {0, 7, 100, 211, 400}) {
        const SurfacePoint place{face, {0.2, 0.5, 0.3}};
        const auto loop = loopAround(tube.links, place);
        ASSERT_TRUE(loop);
        EXPECT_NEAR(loop->length, around, 1e-6 * around);
        EXPECT_EQ(positionOf(tube.mesh, loop->points.front()), positionOf(tube.mesh, place));
        const auto cut = cutAlong(tube.mesh, {*loop});
        ASSERT_TRUE(cut);
        EXPECT_EQ(test::componentCount(cut->mesh), 2);
        // What a project keeps of it gives the same line.
        const UserCut kept{"loop", UserCut::Kind::Loop, placesAlong(tube.mesh, *loop, 6), false};
        ASSERT_EQ(kept.points.size(), 6U);
        const auto again = traceUserCut(tube.links, NearestSurface(tube.mesh), kept);
        ASSERT_TRUE(again);
        EXPECT_NEAR(again->length, loop->length, 1e-6 * around);
    }
}

TEST(LoopAround, FindsNothingToGoAroundOnADisk) {
    const test::Surface sheet(test::planeGrid(8, 8, 10));
    EXPECT_EQ(loopAround(sheet.links, {17, {0.3, 0.3, 0.4}}).error().code,
              ErrorCode::CutImpossible);
    const test::Surface pierced(
        test::without(test::planeGrid(30, 30, 10), [](int f) { return f / 2 == 217; }));
    EXPECT_FALSE(loopAround(pierced.links, {17, {0.3, 0.3, 0.4}}));  // a buttonhole is no opening
    const test::Surface ball(test::sphere(16));
    EXPECT_FALSE(loopAround(ball.links, {17, {0.3, 0.3, 0.4}}));
}

TEST(LoopAround, TakesTheShorterWayOfAHandle) {
    const test::Surface torus(test::closedTorus(32, 16));  // radii 50 and 20
    const auto loop = loopAround(torus.links, {40, {0.3, 0.3, 0.4}});
    ASSERT_TRUE(loop);
    EXPECT_LT(loop->length, 1.01 * 2 * std::numbers::pi * 20);
    const auto cut = cutAlong(torus.mesh, {*loop});
    ASSERT_TRUE(cut);
    EXPECT_EQ(test::componentCount(cut->mesh), 1);
}

}  // namespace
}  // namespace toile
