// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/measures.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/quality/piece_quality.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using std::numbers::pi;

Points2 flat(const MeshArrays& mesh) {
    return mesh.V.leftCols(2);
}

Eigen::VectorXd vectorOf(std::initializer_list<double> values) {
    Eigen::VectorXd v(static_cast<int>(values.size()));
    std::copy(values.begin(), values.end(), v.begin());
    return v;
}

TEST(Measures, AnIsometryHasNoDistortionAtAll) {
    const auto piece = test::asPiece(test::planeGrid(5, 4, 7));
    const double turn = 0.7;
    Eigen::Matrix2d R;
    R << std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn);
    const Points2 Q = (flat(piece->mesh) * R).rowwise() + Eigen::RowVector2d(30, -20);
    const PieceQuality quality = measure(*piece, Q);
    EXPECT_NEAR(quality.area3d, 5 * 4 * 49, 1e-9);
    EXPECT_NEAR(quality.area2d, 5 * 4 * 49, 1e-9);
    EXPECT_NEAR(quality.perimeter3d, 18 * 7, 1e-10);
    EXPECT_LT(quality.piTheta, 1e-12);
    EXPECT_LT(quality.piL, 1e-12);
    EXPECT_LT(quality.piE, 1e-12);
    EXPECT_LT(quality.piA, 1e-12);
    EXPECT_LT(quality.maxBoundaryLengthError, 1e-13);
    EXPECT_NEAR(*quality.symmetricDirichlet, 1, 1e-12);
    EXPECT_NEAR(*quality.quasiConformalMax, 1, 1e-12);
    EXPECT_NEAR(*quality.strainMax, 0, 1e-12);
    EXPECT_EQ(quality.flippedTriangles, 0);
    EXPECT_EQ(quality.outlineCrossings, 0);
}

TEST(Measures, AStretchAlongXHasItsSingularValues) {
    const auto piece = test::asPiece(test::planeGrid(3, 3, 10));
    Points2 Q = flat(piece->mesh);
    Q.col(0) *= 2;
    const Eigen::MatrixX2d singular = singularValues(piece->mesh, Q);
    EXPECT_LT((singular.col(0).array() - 2).abs().maxCoeff(), 1e-12);
    EXPECT_LT((singular.col(1).array() - 1).abs().maxCoeff(), 1e-12);
    const PieceQuality quality = measure(*piece, Q);
    EXPECT_NEAR(*quality.symmetricDirichlet, (4 + 1 + 0.25 + 1) / 4, 1e-12);
    EXPECT_NEAR(*quality.quasiConformalMean, 2, 1e-12);
    EXPECT_NEAR(*quality.strainMin, -0.5, 1e-12);  // half the flat length is surplus
    EXPECT_NEAR(*quality.strainMax, 0, 1e-12);
    EXPECT_NEAR(quality.maxBoundaryLengthError, 1, 1e-12);
    EXPECT_NEAR(quality.piL, 5, 1e-12);  // half of the edges are 10 mm too long
}

TEST(Measures, NormalisedFormsIgnoreScale) {
    const auto cap = test::asPiece(test::sphericalCap(6, 100, 1.2));
    const Points2 Q = cap->mesh.V(Eigen::all, {0, 2});
    const PieceQuality one = measure(*cap, Q);
    const PieceQuality three = measure(*cap, Points2(3 * Q));
    EXPECT_NEAR(one.piE, three.piE, 1e-14);
    EXPECT_NEAR(one.piA, three.piA, 1e-14);
    EXPECT_NEAR(one.piTheta, three.piTheta, 1e-14);
    EXPECT_GT(one.piE, 0.05);
}

TEST(Measures, PiSumsAreWhatTheEquationsSay) {
    EXPECT_DOUBLE_EQ(piL(vectorOf({1, 2, 3}), vectorOf({1, 3, 1})), 1);
    EXPECT_DOUBLE_EQ(piTheta(vectorOf({1, 2}), vectorOf({1.5, 1})), 0.75);
    EXPECT_DOUBLE_EQ(piE(vectorOf({1, 1}), vectorOf({3, 1})), 0.5);
    EXPECT_DOUBLE_EQ(piA(vectorOf({1, 1}), vectorOf({-3, 1})), 0.5);
    EXPECT_DOUBLE_EQ(maxRelativeLengthError(vectorOf({2, 4}), vectorOf({2, 3})), 0.25);
}

TEST(Measures, InnerAnglesOfASquareAndOfANotch) {
    const auto piece = test::asPiece(test::planeGrid(2, 2, 1));
    const Eigen::VectorXd alpha = boundaryAngles3d(piece->mesh, piece->boundary);
    EXPECT_NEAR(alpha.sum(), 6 * pi, 1e-12);  // (n - 2) pi
    EXPECT_NEAR(
        (alpha - boundaryAngles2d(flat(piece->mesh), piece->boundary)).cwiseAbs().maxCoeff(), 0,
        1e-12);
    Points2 notched(4, 2);
    notched << 0, 0, 2, 0, 1, 0.5, 1, 2;  // the third corner points inwards
    const Eigen::VectorXd theta = boundaryAngles2d(notched, {0, 1, 2, 3});
    EXPECT_GT(theta[2], pi);
    EXPECT_NEAR(theta.sum(), 2 * pi, 1e-12);
}

TEST(Measures, CornerAnglesSumToPiInSpaceAndPlane) {
    const auto cap = test::asPiece(test::sphericalCap(5, 80, 1));
    const Points2 Q = cap->mesh.V(Eigen::all, {0, 2});
    EXPECT_LT((cornerAngles3d(cap->mesh).rowwise().sum().array() - pi).abs().maxCoeff(), 1e-12);
    EXPECT_LT((cornerAngles2d(Q, cap->mesh.F).rowwise().sum().array() - pi).abs().maxCoeff(),
              1e-12);
}

TEST(Measures, CountsFlipsAndGivesNoInfiniteEnergy) {
    const auto piece = test::asPiece(test::planeGrid(4, 4, 10));
    Points2 Q = flat(piece->mesh);
    Q.row(12) += Eigen::RowVector2d(25, 0);  // the middle vertex over its neighbours
    const PieceQuality quality = measure(*piece, Q);
    EXPECT_GT(quality.flippedTriangles, 0);
    EXPECT_FALSE(quality.symmetricDirichlet);
    Q.row(12) = Q.row(13);  // an edge without length
    const PieceQuality collapsed = measure(*piece, Q);
    EXPECT_FALSE(collapsed.symmetricDirichlet);
    EXPECT_FALSE(collapsed.quasiConformalMax);
    EXPECT_FALSE(collapsed.strainMax);
}

TEST(Measures, ATriangleThatIsPositiveByRoundingHasCollapsed) {
    const auto piece = test::asPiece(test::planeGrid(1, 1, 10));
    const Points2 flattened = flat(piece->mesh);
    const Eigen::VectorXd worn = triangleAreas3d(piece->mesh);
    const int tip = piece->mesh.F(0, 0), first = piece->mesh.F(0, 1), second = piece->mesh.F(0, 2);
    for (const double left : {1e-20, 1e-12, 1e-4}) {
        Points2 Q = flattened;
        const Eigen::RowVector2d base = 0.5 * (Q.row(first) + Q.row(second));
        Q.row(tip) = base + left * (flattened.row(tip) - base);
        const PieceQuality quality = measure(*piece, Q);
        const bool isCollapsed = left < kCollapsedShare;
        EXPECT_EQ(quality.flippedTriangles > 0, isCollapsed) << left;
        EXPECT_EQ(quality.symmetricDirichlet.has_value(), !isCollapsed) << left;
        EXPECT_TRUE(!isCollapsed || worstFlipped(triangleAreas2d(Q, piece->mesh.F), worn) == 0);
    }
}

TEST(Measures, FieldsAgreeWithTheFigures) {
    const auto piece = test::asPiece(test::planeGrid(3, 2, 10));
    Points2 Q = flat(piece->mesh);
    Q.col(0) *= 1.25;
    const DistortionFields fields = distortionFields(*piece, Q);
    EXPECT_LT((fields.areaChange.array() - 0.25).abs().maxCoeff(), 1e-12);
    EXPECT_NEAR(fields.edgeStrain.minCoeff(), 1 / 1.25 - 1, 1e-12);
    EXPECT_NEAR(fields.angleChange.maxCoeff(), std::atan(1.25) - pi / 4, 1e-12);
}

}  // namespace
}  // namespace toile
