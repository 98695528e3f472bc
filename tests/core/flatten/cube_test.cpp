// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// [Wang05] Table 1, Example IV: Pi_theta 0.039, Pi_E 0.273, Pi_A 0.485, 8 to 10 iterations.
class Cube : public testing::TestWithParam<BoundarySolver> {};

TEST_P(Cube, GivesThePapersFigures) {
    const auto cube = test::asPiece(test::cubeOpenedAlongH());
    ASSERT_FALSE(cube->defect) << sentence(*cube->defect);
    ASSERT_EQ(cube->mesh.F.rows(), 768);
    ASSERT_EQ(cube->boundary.size(), 80U);
    Progress progress;
    const auto flat = flatten(*cube, {Method::Wang2005, GetParam()}, progress);
    ASSERT_TRUE(flat) << sentence(flat.error());
    const PieceQuality quality = measure(*cube, flat->Q);
    EXPECT_NEAR(quality.piTheta, 0.0393, 0.0001);
    EXPECT_NEAR(quality.piTheta, std::numbers::pi / 80, 1e-5);
    EXPECT_GE(quality.piE, 0.267);
    EXPECT_LE(quality.piE, 0.280);
    EXPECT_GE(quality.piA, 0.483);
    EXPECT_LE(quality.piA, 0.487);
    EXPECT_LE(quality.maxBoundaryLengthError, 1e-12);
    EXPECT_LE(flat->boundaryIterations, 10);
}

INSTANTIATE_TEST_SUITE_P(Solvers, Cube,
                         testing::Values(BoundarySolver::Newton, BoundarySolver::Slcp),
                         [](const auto& shown) { return std::string(name(shown.param)); });

}  // namespace
}  // namespace toile
