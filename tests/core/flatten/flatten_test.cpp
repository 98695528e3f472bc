// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/flatten.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

TEST(Flatten, ASingleTriangleKeepsItsShape) {
    MeshArrays mesh{Points3(3, 3), Triangles(1, 3)};
    mesh.V << 0, 0, 0, 40, 0, 30, 0, 60, 0;
    mesh.F << 0, 1, 2;
    const auto piece = test::asPiece(mesh);
    for (const Method method : {Method::Wang2005, Method::Natural}) {
        Progress progress;
        const auto flat = flatten(*piece, {method, BoundarySolver::Newton}, progress);
        ASSERT_TRUE(flat) << sentence(flat.error());
        EXPECT_LE(measure(*piece, flat->Q).maxBoundaryLengthError, 1e-12);
        EXPECT_NEAR(triangleAreas2d(flat->Q, mesh.F)[0], 1500, 1e-9);
    }
}

TEST(Flatten, KeepsBoundaryLengthsOfACap) {
    const auto cap = test::asPiece(test::sphericalCap(12, 90, 1.2));
    Progress progress;
    const auto wang = flatten(*cap, {}, progress);
    const auto natural = flatten(*cap, {Method::Natural, BoundarySolver::Newton}, progress);
    ASSERT_TRUE(wang && natural);
    const PieceQuality exact = measure(*cap, wang->Q);
    EXPECT_LE(exact.maxBoundaryLengthError, 1e-12);
    EXPECT_EQ(exact.flippedTriangles, 0);
    EXPECT_EQ(exact.outlineCrossings, 0);
    // Pi_theta can never be below |total interior curvature| / n; on a round cap it is just that.
    const double bound =
        std::abs(boundaryAngles3d(cap->mesh, cap->boundary).sum() -
                 (static_cast<double>(cap->boundary.size()) - 2) * std::numbers::pi) /
        static_cast<double>(cap->boundary.size());
    EXPECT_NEAR(exact.piTheta, bound, 1e-12);
    EXPECT_NEAR(measure(*cap, natural->Q).perimeter2d, exact.perimeter3d, 1e-9);
}

TEST(Flatten, NaturalIsMoreConformalButLosesLengths) {
    const auto saddle = test::asPiece(test::saddle(16, 200, 1.2));
    Progress progress;
    const auto wang = flatten(*saddle, {}, progress);
    const auto natural = flatten(*saddle, {Method::Natural, BoundarySolver::Newton}, progress);
    ASSERT_TRUE(wang && natural);
    const PieceQuality exact = measure(*saddle, wang->Q);
    const PieceQuality free = measure(*saddle, natural->Q);
    EXPECT_LT(*free.quasiConformalMean, *exact.quasiConformalMean);
    EXPECT_GT(free.maxBoundaryLengthError, 1e-3);
    EXPECT_LE(exact.maxBoundaryLengthError, 1e-12);
}

TEST(Flatten, NeverMirrorsAndStandsUpright) {
    const auto sleeve = test::asPiece(test::cylinderSector(24, 9, 80, 2.5, 150));
    for (const Method method : {Method::Wang2005, Method::Natural}) {
        Progress progress;
        const auto flat = flatten(*sleeve, {method, BoundarySolver::Newton}, progress);
        ASSERT_TRUE(flat);
        EXPECT_GT(triangleAreas2d(flat->Q, sleeve->mesh.F).minCoeff(), 0);
        EXPECT_NEAR(flat->Q.minCoeff(), 0, 1e-12);
        // The garment's vertical is the cylinder's axis: heights agree but for a shift.
        const Eigen::VectorXd shift = flat->Q.col(1) - sleeve->mesh.V.col(1);
        EXPECT_LT(shift.maxCoeff() - shift.minCoeff(), 1e-6);
    }
}

TEST(Flatten, ALevelPieceLiesAlongItsLength) {
    MeshArrays band = test::planeGrid(30, 3, 10);
    band.V.col(2) = -band.V.col(1);  // laid flat, right side up
    band.V.col(1).setZero();
    const auto piece = test::asPiece(band);
    Progress progress;
    const auto flat = flatten(*piece, {}, progress);
    ASSERT_TRUE(flat);
    EXPECT_NEAR(flat->Q.col(0).maxCoeff(), 300, 1e-6);
    EXPECT_NEAR(flat->Q.col(1).maxCoeff(), 30, 1e-6);
}

TEST(Flatten, PassesOnWhatIsWrongWithThePiece) {
    const auto tube = test::asPiece(test::tube(12, 4), "leg");
    Progress progress;
    const auto flat = flatten(*tube, {}, progress);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::SeveralLoops);
    EXPECT_EQ(flat.error().subject.name, "leg");
}

TEST(Flatten, EveryMethodRefusesCoordinatesThatHaveNoFigures) {
    for (const MethodTraits& method : allMethods()) {
        SCOPED_TRACE(method.name);
        FlattenOptions options;
        options.method = method.method;
        for (const auto& [scale, fits] : {std::pair(1e70, true), std::pair(1e100, false)}) {
            MeshArrays mesh = test::saddle(6, 100, 0.3);
            mesh.V *= scale;
            const auto piece = test::asPiece(std::move(mesh));
            const auto flat = flatten(*piece, options, Progress());
            ASSERT_EQ(flat.ok(), fits) << (fits ? sentence(flat.error()) : "");
            if (fits) {
                EXPECT_TRUE(measure(*piece, flat->Q).symmetricDirichlet);
            } else {
                EXPECT_EQ(flat.error().code, ErrorCode::NotFinite);
                EXPECT_NE(flat.error().detail.find("coordinates reach"), std::string::npos);
            }
        }
    }
}

TEST(Flatten, CanBeCancelled) {
    const auto cap = test::asPiece(test::sphericalCap(8, 90, 1));
    Progress progress;
    progress.cancel();
    const auto flat = flatten(*cap, {}, progress);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::Cancelled);
}

TEST(Flatten, GivesTheSameBytesAgain) {
    const auto cap = test::asPiece(test::sphericalCap(20, 90, 1.4));
    Progress progress;
    const auto a = flatten(*cap, {}, progress);
    const auto b = flatten(*cap, {}, progress);
    ASSERT_TRUE(a && b);
    EXPECT_TRUE((a->Q.array() == b->Q.array()).all());
}

TEST(Flatten, WordsOfOptionsReadBack) {
    for (const Method method : {Method::Natural, Method::Wang2005}) {
        EXPECT_EQ(parseMethod(name(method)), method);
    }
    for (const BoundarySolver solver : {BoundarySolver::Newton, BoundarySolver::Slcp}) {
        EXPECT_EQ(parseBoundarySolver(name(solver)), solver);
    }
    EXPECT_FALSE(parseMethod("magic"));
}

}  // namespace
}  // namespace toile
