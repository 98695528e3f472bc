// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/check/piece_check.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

TEST(StrainCheck, FlatClothKeepsWithinAnyLimits) {
    const MeshArrays mesh = test::planeGrid(5, 5, 20);
    const Fabric stiff{"stiff", {0, 0}, {0, 0}, {0, 0}};
    const StrainExcesses none = strainExcesses(mesh, mesh.V.leftCols<2>(), stiff, 0.3);
    EXPECT_EQ(none.warp.share + none.weft.share + none.bias.share, 0);
}

TEST(StrainCheck, TurningGrainAndClothTogetherChangesNothing) {
    MeshArrays mesh = test::saddle(10, 200, 0.002);
    const Fabric fabric = *fabricPreset("denim");
    const Points2 Q = mesh.V.leftCols<2>();
    const StrainExcesses before = strainExcesses(mesh, Q, fabric, 0.4);
    const double turn = 1.1;
    Eigen::Matrix2d rotation;
    rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
    const Points2 turned = Q * rotation.transpose();
    const StrainExcesses after = strainExcesses(mesh, turned, fabric, 0.4 + turn);
    EXPECT_NEAR(before.warp.share, after.warp.share, 1e-9);
    EXPECT_NEAR(before.warp.strain, after.warp.strain, 1e-9);
    EXPECT_NEAR(before.bias.severity, after.bias.severity, 1e-9);
}

TEST(StrainCheck, SurplusIsHeldToTheLowerLimit) {
    const MeshArrays mesh = test::planeGrid(4, 4, 20);
    Points2 Q = mesh.V.leftCols<2>();
    Q.col(0) /= 0.9;  // the cloth must take in a tenth along x
    const StrainExcesses found =
        strainExcesses(mesh, Q, *fabricPreset("woven"), std::numbers::pi / 2);
    EXPECT_NEAR(found.weft.strain, -0.1, 1e-12);
    EXPECT_EQ(found.weft.limit, fabricPreset("woven")->weft.least);
    EXPECT_NEAR(found.weft.share, 1, 1e-12);
    EXPECT_NEAR(found.weft.severity, 10, 1e-9);
    EXPECT_EQ(found.warp.share, 0);
}

TEST(StrainCheck, TrianglesCountByTheirFlatAreaAndOneByOne) {
    const MeshArrays mesh = test::planeGrid(2, 2, 20);
    Points2 Q = mesh.V.leftCols<2>();
    Q.col(0) *= -1;  // all edges keep their lengths
    const StrainExcesses turned = strainExcesses(mesh, Q, *fabricPreset("jersey"), 0);
    EXPECT_NEAR(turned.warp.share, 1, 1e-12);

    // One corner of one triangle pulled: the others keep their shape.
    Q = mesh.V.leftCols<2>();
    Eigen::Index corner = 0;
    for (; (mesh.F.array() == corner).count() != 1; ++corner) {
    }
    Q.row(corner) += (Q.row(corner) - Q.colwise().mean()) * 0.5;
    const StrainExcesses found = strainExcesses(mesh, Q, *fabricPreset("woven"), 0);
    ASSERT_GE(found.warp.face, 0);
    EXPECT_TRUE((mesh.F.row(found.warp.face).array() == corner).any());
    EXPECT_GT(found.warp.share, 0.125);  // its flat cloth is larger than that of the other seven
    EXPECT_LT(found.warp.share, 0.25);
}

TEST(StrainCheck, CollapsedTrianglesStayFinite) {
    const MeshArrays mesh = test::planeGrid(3, 3, 20);
    const StrainExcesses found =
        strainExcesses(mesh, Points2::Zero(mesh.V.rows(), 2), *fabricPreset("woven"), 0);
    EXPECT_TRUE(std::isfinite(found.warp.strain));
    EXPECT_NEAR(found.warp.share, 1, 1e-12);
}

}  // namespace
}  // namespace toile
