// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/prepare/recognise.h"
#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using test::beside;

MeshArrays shirt() {
    return test::planeGrid(30, 30, 30);  // 900 mm square
}

TEST(Debris, OnePieceHasNone) {
    EXPECT_EQ(findDebris(shirt()).fragments, 0);
    EXPECT_EQ(findDebris({}).fragments, 0);
}

TEST(Debris, SmallFragmentsAreCountedAndMeasured) {
    MeshArrays mesh = beside(shirt(), test::planeGrid(4, 2, 5), {100, 100, 10});
    mesh = beside(mesh, test::planeGrid(1, 1, 4), {2000, 0, 0});
    const Debris debris = findDebris(mesh);
    EXPECT_EQ(debris.fragments, 2);
    EXPECT_NEAR(debris.area, 4 * 2 * 25 + 16, 1e-6);
    EXPECT_EQ(debris.triangles.size(), 16U + 2U);
    EXPECT_EQ(debris.triangles.front(), shirt().F.rows());
}

TEST(Debris, ABeltACordAndBeltLoopsStay) {
    const MeshArrays belt = test::planeGrid(40, 1, 20);  // a fiftieth of the cloth
    EXPECT_EQ(findDebris(beside(shirt(), belt, {0, 0, 20})).fragments, 0);
    const MeshArrays cord = test::planeGrid(300, 1, 1.5);  // less than a thousandth, but long
    EXPECT_EQ(findDebris(beside(shirt(), cord, {0, 0, 20})).fragments, 0);
    const MeshArrays loop = test::planeGrid(2, 10, 4);
    MeshArrays loops = shirt();
    for (int i = 0; i < 5; ++i) {
        loops = beside(loops, loop, {100.0 * i, 0, 10});
    }
    EXPECT_EQ(findDebris(loops).fragments, 0);
    EXPECT_EQ(findDebris(beside(shirt(), loop, {0, 0, 10})).fragments, 1);
}

TEST(Debris, ClothInPiecesIsNone) {
    MeshArrays mesh = test::planeGrid(10, 10, 90);
    MeshArrays crumbs = test::planeGrid(30, 30, 10);  // each triangle by itself
    Points3 V(3 * crumbs.F.rows(), 3);
    for (int corner = 0; corner < V.rows(); ++corner) {
        V.row(corner) = crumbs.V.row(crumbs.F.data()[corner]);
        crumbs.F.data()[corner] = corner;
    }
    crumbs.V = V;
    EXPECT_EQ(findDebris(beside(mesh, crumbs, {1000, 0, 0})).fragments, 0);
}

}  // namespace
}  // namespace toile
