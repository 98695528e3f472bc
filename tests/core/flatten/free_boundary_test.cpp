// SPDX-License-Identifier: GPL-3.0-or-later
// The conformal maps without a fixed outline: natural (pinned and spectral), lscm and abf.

#include <cmath>

#include <gtest/gtest.h>

#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/flatten.h"
#include "core/flatten/reference/abf_angles.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

FlattenOptions spectral() {
    FlattenOptions options{Method::Natural};
    options.freeBoundary = FreeBoundary::Spectral;
    return options;
}

std::vector<FlattenOptions> freeMethods() {
    return {{Method::Natural}, spectral(), {Method::Lscm}, {Method::Abf}};
}

Points2 pointsOf(const Piece& piece, const FlattenOptions& options) {
    Progress progress;
    const auto flat = flatten(piece, options, progress);
    EXPECT_TRUE(flat) << (flat ? "" : sentence(flat.error()));
    return flat ? flat->Q : Points2::Zero(piece.mesh.V.rows(), 2).eval();
}

double edgeError(const Piece& piece, const Points2& Q) {
    return maxRelativeLengthError(edgeLengths3d(piece.mesh.V, piece.table.edges),
                                  edgeLengths2d(Q, piece.table.edges));
}

/// Root mean square change of a corner's angle, weighted by 3D area.
double angleError(const Piece& piece, const Points2& Q) {
    const Eigen::VectorXd areas = triangleAreas3d(piece.mesh);
    const Eigen::MatrixX3d change = cornerAngles2d(Q, piece.mesh.F) - cornerAngles3d(piece.mesh);
    return std::sqrt(areas.dot(change.rowwise().squaredNorm()) / (3 * areas.sum()));
}

TEST(FreeBoundaryMethods, ALongStripKeepsItsDigits) {
    // 2000 squares in a row, flat and rolled up: the energies of near-conformal bends z^2 are
    // 1e-14 of a stretched edge's. Solved from the normal matrix alone, four digits were left.
    for (const MeshArrays& mesh :
         {test::planeGrid(2000, 1, 1), test::cylinderSector(2000, 1, 400, 5, 1)}) {
        const auto strip = test::asPiece(mesh);
        EXPECT_LE(edgeError(*strip, pointsOf(*strip, {Method::Natural})), 1e-10);
        EXPECT_LE(edgeError(*strip, pointsOf(*strip, spectral())), 1e-10);
        EXPECT_LE(edgeError(*strip, pointsOf(*strip, {Method::Lscm})), 1e-10);
        EXPECT_LE(edgeError(*strip, pointsOf(*strip, {Method::Abf})), 1e-10);
    }
}

TEST(FreeBoundaryMethods, HaveTheTruePerimeterAndAreNotMirrored) {
    for (const MeshArrays& mesh :
         {test::sphericalCap(12, 90, 1.2), test::saddle(16, 200, 1.2), test::cubeOpenedAlongH()}) {
        const auto piece = test::asPiece(mesh);
        for (const FlattenOptions& options : freeMethods()) {
            SCOPED_TRACE(name(options.method));
            const PieceQuality quality = measure(*piece, pointsOf(*piece, options));
            EXPECT_NEAR(quality.perimeter2d, quality.perimeter3d, 1e-9 * quality.perimeter3d);
            EXPECT_EQ(quality.flippedTriangles, 0);
        }
    }
}

TEST(FreeBoundaryMethods, NearlyKeepTheAnglesOfACap) {
    // A finer mesh of the same cap is kept better: what is left is discretisation.
    for (const FlattenOptions& options : freeMethods()) {
        SCOPED_TRACE(name(options.method));
        const auto coarse = test::asPiece(test::sphericalCap(10, 90, 1.2));
        const auto fine = test::asPiece(test::sphericalCap(40, 90, 1.2));
        const double coarseError = angleError(*coarse, pointsOf(*coarse, options));
        const double fineError = angleError(*fine, pointsOf(*fine, options));
        EXPECT_LT(coarseError, 0.03);
        EXPECT_LT(fineError, 0.5 * coarseError);
    }
}

TEST(FreeBoundaryMethods, AngleBasedKeepsAnglesBestWhereCurvatureIsStrong) {
    const auto cube = test::asPiece(test::cubeOpenedAlongH());
    const double abf = angleError(*cube, pointsOf(*cube, {Method::Abf}));
    EXPECT_LT(abf, angleError(*cube, pointsOf(*cube, {Method::Lscm})));
    EXPECT_LT(abf, angleError(*cube, pointsOf(*cube, {Method::Natural})));
}

TEST(ConformalEnergy, IsTheDirichletEnergyMinusTheArea) {
    const auto piece = test::asPiece(test::saddle(10, 200, 1.2));
    const Points2 Q = pointsOf(*piece, {Method::Wang2005});
    Eigen::VectorXcd z(Q.rows());
    z.real() = Q.col(0);
    z.imag() = Q.col(1);
    const Eigen::MatrixX2d s = singularValues(piece->mesh, Q);
    const Eigen::VectorXd areas = triangleAreas3d(piece->mesh);
    const double dirichlet = 0.5 * areas.dot(s.rowwise().squaredNorm());
    const double area = triangleAreas2d(Q, piece->mesh.F).sum();
    const double energy = 0.5 * ConformalEnergy(piece->mesh).residual(z).squaredNorm();
    EXPECT_NEAR(energy, dirichlet - area, 1e-10 * area);
}

TEST(ConformalEnergy, AnglesAloneDescribeItsTriangles) {
    const auto piece = test::asPiece(test::saddle(10, 200, 1.2));
    const ConformalEnergy byPlace(piece->mesh);
    const ConformalEnergy byAngles(piece->mesh.F, cornerAngles3d(piece->mesh),
                                   static_cast<int>(piece->mesh.V.rows()));
    const Eigen::VectorXcd z = Eigen::VectorXcd::Random(piece->mesh.V.rows());
    EXPECT_LE(
        (byPlace.residual(z).cwiseAbs() - byAngles.residual(z).cwiseAbs()).cwiseAbs().maxCoeff(),
        1e-12);
}

TEST(Natural, SpectralDependsOnNoVertex) {
    const MeshArrays mesh = test::saddle(12, 200, 0.8);
    const test::Renumbered other = test::renumber(mesh, 17);
    const Points2 a = pointsOf(*test::asPiece(mesh), spectral());
    const Points2 b = pointsOf(*test::asPiece(other.mesh), spectral());
    EXPECT_LE(test::distanceAfterRigidMotion(a, b(other.newIndex, Eigen::all)), 1e-7);
}

TEST(Natural, SpectralHasTheLeastEnergyForItsSpread) {
    const auto piece = test::asPiece(test::saddle(12, 200, 0.8));
    const ConformalEnergy energy(piece->mesh);
    const auto perSpread = [&](const Points2& Q) {
        Points2 edge = Q(piece->boundary, Eigen::all);
        const Eigen::RowVector2d middle = edge.colwise().mean();
        edge.rowwise() -= middle;
        Eigen::VectorXcd z(Q.rows());
        z.real() = Q.col(0);
        z.imag() = Q.col(1);
        return energy.residual(z).squaredNorm() / edge.squaredNorm();
    };
    const double least = perSpread(pointsOf(*piece, spectral()));
    EXPECT_LT(least, perSpread(pointsOf(*piece, {Method::Natural})));
    EXPECT_LT(least, perSpread(pointsOf(*piece, {Method::Abf})));
    EXPECT_LT(least, perSpread(pointsOf(*piece, {Method::Curvature})));
}

TEST(Lscm, PinsAreFarApartAlongARolledPiece) {
    // Nearly closed around: its long ends lie side by side in space.
    const auto roll = test::asPiece(test::cylinderSector(60, 4, 50, 6.2, 20));
    const auto near = [&](std::array<int, 2> pins) {
        return (roll->mesh.V.row(pins[0]) - roll->mesh.V.row(pins[1])).norm();
    };
    EXPECT_GT(near(farPairInSpace(*roll)), 100);
    EXPECT_LT(near(farPairAlongEdges(*roll)), 25);
}

TEST(AbfAngles, HoldEveryConstraint) {
    for (const MeshArrays& mesh : {test::sphericalCap(12, 90, 2.2), test::saddle(16, 200, 1.2),
                                   test::cubeSlitAlongOneEdge()}) {
        const auto piece = test::asPiece(mesh);
        const auto planar = closestPlanarAngles(piece->mesh, piece->boundary, Progress());
        ASSERT_TRUE(planar) << sentence(planar.error());
        EXPECT_LE(planar->residual, 1e-10);
        EXPECT_GT(planar->angles.minCoeff(), 0);
        // Angles that fit are met by the planar points.
        const Points2 Q = pointsOf(*piece, {Method::Abf});
        EXPECT_LE((cornerAngles2d(Q, mesh.F) - planar->angles).cwiseAbs().maxCoeff(), 1e-8);
    }
}

TEST(AbfAngles, AFlatPieceNeedsNoStep) {
    const auto piece = test::asPiece(test::coneSector(20, 8, 120, 300, 2.2, 0.5));
    const auto planar = closestPlanarAngles(piece->mesh, piece->boundary, Progress());
    ASSERT_TRUE(planar);
    EXPECT_LE((planar->angles - cornerAngles3d(piece->mesh)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE(planar->iterations, 2);
}

}  // namespace
}  // namespace toile
