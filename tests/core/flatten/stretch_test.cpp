// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// Sander's L2 stretch of the plane-to-surface map.
double stretchOf(const Piece& piece, const Points2& Q) {
    const Eigen::VectorXd areas = triangleAreas3d(piece.mesh);
    const Eigen::ArrayXXd s = singularValues(piece.mesh, Q).array();
    return std::sqrt(areas.dot((0.5 * s.square().inverse().rowwise().sum()).matrix()) /
                     areas.sum());
}

void expectLessStretch(const Piece& piece, double factor) {
    Progress progress;
    const auto start = flatten(piece, {Method::Curvature}, progress);
    FlattenOptions options{Method::Stretch};
    options.stretchOutline = StretchOutline::Curvature;
    const auto flat = flatten(piece, options, progress);
    ASSERT_TRUE(start && flat);
    EXPECT_LT(stretchOf(piece, flat->Q), factor * stretchOf(piece, start->Q));
    EXPECT_GT(flat->interiorIterations, 0);
    const PieceQuality before = measure(piece, start->Q);
    const PieceQuality after = measure(piece, flat->Q);
    EXPECT_LE(after.flippedTriangles, before.flippedTriangles);
    EXPECT_LE(after.maxBoundaryLengthError, 1e-11);
    EXPECT_NEAR(after.piTheta, before.piTheta, 1e-9);
}

TEST(Stretch, IsLessThanTheConformalInteriors) {
    expectLessStretch(*test::asPiece(test::sphericalCap(14, 90, 1.6)), 0.98);
    expectLessStretch(*test::asPiece(test::cubeOpenedAlongH()), 0.98);
    expectLessStretch(*test::asPiece(test::saddle(16, 200, 1.2)), 1);
}

TEST(Stretch, OnACircleIsLessThanItsStartAndFlipsNothing) {
    for (const MeshArrays& mesh : {test::sphericalCap(14, 90, 1.6), test::cubeOpenedAlongH(),
                                   test::cubeSlitAlongOneEdge(), test::saddle(16, 200, 1.2)}) {
        const auto piece = test::asPiece(mesh);
        Progress progress;
        const auto start = flatten(*piece, {Method::Convex}, progress);
        const auto flat = flatten(*piece, {Method::Stretch}, progress);
        ASSERT_TRUE(start && flat);
        EXPECT_LT(stretchOf(*piece, flat->Q), stretchOf(*piece, start->Q));
        const PieceQuality after = measure(*piece, flat->Q);
        EXPECT_EQ(after.flippedTriangles, 0);
        EXPECT_LE(after.maxBoundaryLengthError, 1e-11);
    }
}

class StronglyCurved : public testing::TestWithParam<const char*> {};

TEST_P(StronglyCurved, HaveTheirStretchHalvedAndMore) {
    const auto file = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment) << sentence(garment.error());
    expectLessStretch(*garment->pieces.front(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Shared, StronglyCurved,
                         testing::Values("disks/lion-head.off", "disks/face.obj"));

TEST(Stretch, OfABulbIsLessByAThird) {
    expectLessStretch(*test::asPiece(test::sphericalCap(24, 90, 2.4)), 2.0 / 3);
}

TEST(Stretch, ObtuseTrianglesDoNoHarm) {
    // Some cotangent weights are negative here: the mean value weights take over.
    MeshArrays mesh = test::sphericalCap(14, 90, 1.4);
    mesh.V.col(0) *= 3.5;
    expectLessStretch(*test::asPiece(mesh), 1);
}

}  // namespace
}  // namespace toile
