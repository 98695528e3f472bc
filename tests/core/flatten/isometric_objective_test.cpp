// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of the isometric objective against finite differences and known values.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/kkt_solver.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "tests/core/support/generator.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

constexpr double kStep = 1e-6;

Points2 flatGrid(const Piece& piece) {
    return piece.mesh.V.leftCols<2>();
}

/// The grid pulled about without flipping a triangle.
Points2 shaken(const Piece& piece, double amount) {
    Points2 Q = flatGrid(piece);
    for (int v = 0; v < Q.rows(); ++v) {
        Q.row(v) += amount * Eigen::RowVector2d(std::sin(3.7 * v), std::cos(2.3 * v));
    }
    return Q;
}

Points2 randomDirection(Eigen::Index rows) {
    Points2 P(rows, 2);
    for (int v = 0; v < rows; ++v) {
        P.row(v) << std::sin(1.3 * v + 0.2), std::sin(2.9 * v + 1);
    }
    return P;
}

std::shared_ptr<const Piece> grid() {
    return test::asPiece(test::planeGrid(4, 3, 1.0));
}

isometric::IsometricObjective objectiveOf(const Piece& piece, bool simple) {
    return {piece.mesh, piece.table, piece.boundary,
            boundaryLengths3d(piece.mesh.V, piece.boundary), simple};
}

double dot(const Points2& a, const Points2& b) {
    return a.cwiseProduct(b).sum();
}

Eigen::VectorXd times(const linalg::SymmetricMatrix& M, const Points2& P) {
    const Eigen::Map<const Eigen::VectorXd> p(P.data(), P.size());
    Eigen::VectorXd y = Eigen::VectorXd::Zero(M.size);
    for (int j = 0; j < M.size; ++j) {
        for (int k = M.columnStart[j]; k < M.columnStart[j + 1]; ++k) {
            y[M.row[k]] += M.value[k] * p[j];
            if (M.row[k] != j) {
                y[j] += M.value[k] * p[M.row[k]];
            }
        }
    }
    return y;
}

TEST(IsometricObjective, IsOneWhereNothingIsStretched) {
    const auto piece = grid();
    const auto objective = objectiveOf(*piece, false);
    Points2 Q = flatGrid(*piece);
    EXPECT_NEAR(objective.evaluate(Q).total, 1, 1e-14);
    const double turn = 0.7;
    Eigen::Matrix2d R;
    R << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
    Q = (Q * R.transpose()).rowwise() + Eigen::RowVector2d(100, -50);
    EXPECT_NEAR(objective.evaluate(Q).total, 1, 1e-12);
    EXPECT_NEAR(objective.distortion(2 * Q), (4 + 4 + 0.25 + 0.25) / 4, 1e-12);
}

TEST(IsometricObjective, AgreesWithTheMeasure) {
    const auto piece = test::asPiece(test::sphericalCap(6, 10, 1.0));
    const auto objective = objectiveOf(*piece, false);
    Points2 Q(piece->mesh.V.rows(), 2);
    Q << piece->mesh.V.col(0), -piece->mesh.V.col(2);
    if (triangleAreas2d(Q, piece->mesh.F).sum() < 0) {
        Q.col(1) *= -1;
    }
    const auto measured =
        symmetricDirichlet(singularValues(piece->mesh, Q), triangleAreas3d(piece->mesh),
                           triangleAreas2d(Q, piece->mesh.F));
    ASSERT_TRUE(measured);
    EXPECT_NEAR(objective.distortion(Q), *measured, 1e-12 * *measured);
}

TEST(IsometricObjective, IsInfiniteWhereATriangleIsFlippedOrFlat) {
    const auto piece = grid();
    const auto objective = objectiveOf(*piece, false);
    Points2 Q = flatGrid(*piece);
    Q.col(1) *= -1;
    EXPECT_EQ(objective.evaluate(Q).total, std::numeric_limits<double>::infinity());
    Q.col(1).setZero();
    EXPECT_EQ(objective.evaluate(Q).total, std::numeric_limits<double>::infinity());
}

TEST(IsometricObjective, GradientIsTheDerivative) {
    const auto piece = grid();
    const auto objective = objectiveOf(*piece, false);
    const Points2 Q = shaken(*piece, 0.15);
    const Points2 P = randomDirection(Q.rows());
    const auto at = objective.evaluate(Q);
    ASSERT_TRUE(std::isfinite(at.total));
    const double numeric =
        (objective.evaluate(Q + kStep * P).total - objective.evaluate(Q - kStep * P).total) /
        (2 * kStep);
    EXPECT_NEAR(dot(objective.gradient(Q, at), P), numeric, 1e-7 * std::abs(numeric));
}

/// Where no eigenvalue had to be raised and the outline's own curvature is nil, the Hessian is the
/// gradient's derivative: under a strong even stretch.
TEST(IsometricObjective, HessianIsTheGradientsDerivativeUnderStretch) {
    const auto piece = grid();
    auto energy = isometric::SymmetricDirichlet(piece->mesh, piece->table);
    const Points2 Q = 1.5 * shaken(*piece, 0.05);
    const Points2 P = randomDirection(Q.rows());
    linalg::BlockMatrix H(piece->table.edges, static_cast<int>(Q.rows()));
    std::vector<int> edgeOf(static_cast<std::size_t>(piece->table.edges.rows()));
    for (std::size_t e = 0; e < edgeOf.size(); ++e) {
        edgeOf[e] = static_cast<int>(e);
    }
    energy.addHessian(Q, edgeOf, H);
    const Points2 numeric =
        (energy.gradient(Q + kStep * P) - energy.gradient(Q - kStep * P)) / (2 * kStep);
    const Eigen::VectorXd product = times(H.matrix(), P);
    EXPECT_LE((product - Eigen::Map<const Eigen::VectorXd>(numeric.data(), numeric.size()))
                  .lpNorm<Eigen::Infinity>(),
              1e-6 * product.lpNorm<Eigen::Infinity>());
}

TEST(IsometricObjective, HessianIsNeverNegative) {
    const auto piece = grid();
    auto objective = objectiveOf(*piece, false);
    for (const double scale : {0.3, 1.0, 3.0}) {
        const Points2 Q = scale * shaken(*piece, 0.2);
        const auto at = objective.evaluate(Q);
        ASSERT_TRUE(std::isfinite(at.total));
        const auto hessian = objective.hessian(Q, at);
        for (int seed = 0; seed < 20; ++seed) {
            Points2 P(Q.rows(), 2);
            for (int v = 0; v < P.rows(); ++v) {
                P.row(v) << std::sin(seed + 12.9898 * v), std::cos(3.1 * seed + 78.233 * v);
            }
            const Eigen::Map<const Eigen::VectorXd> p(P.data(), P.size());
            EXPECT_GE(p.dot(times(hessian.matrix.matrix(), P)), 0);
        }
    }
}

/// A comb with two teeth, whose neighbouring sides are close.
std::shared_ptr<const Piece> narrowGap(double gap) {
    MeshArrays mesh{Points3::Zero(8, 3), Triangles::Zero(6, 3)};
    mesh.V << 0, 0, 0, 2 + gap, 0, 0, 2 + gap, 1, 0, 1 + gap, 1, 0,  //
        1 + gap, 0.5, 0, 1, 0.5, 0, 1, 1, 0, 0, 1, 0;
    mesh.F << 0, 1, 4, 0, 4, 5, 1, 2, 4, 2, 3, 4, 0, 5, 7, 5, 6, 7;
    return test::asPiece(std::move(mesh));
}

TEST(OutlineBarrier, SeesAVertexNearAnEdge) {
    const auto piece = narrowGap(0.02);
    ASSERT_FALSE(piece->defect);
    const auto objective = objectiveOf(*piece, true);
    const Points2 Q = flatGrid(*piece);
    const auto at = objective.evaluate(Q);
    EXPECT_FALSE(at.contacts.empty());
    EXPECT_GT(at.total, objective.distortion(Q));
    for (const auto& contact : at.contacts) {
        EXPECT_LT(contact.distance, contact.radius);
        EXPECT_NEAR(contact.away.norm(), 1, 1e-12);
    }
    EXPECT_TRUE(objectiveOf(*grid(), true).evaluate(flatGrid(*grid())).contacts.empty());
}

TEST(OutlineBarrier, GradientIsTheDerivative) {
    const auto piece = narrowGap(0.03);
    const auto objective = objectiveOf(*piece, true);
    Points2 Q = shaken(*piece, 0.003);
    const Points2 P = randomDirection(Q.rows());
    const auto at = objective.evaluate(Q);
    ASSERT_FALSE(at.contacts.empty());
    const double step = 1e-7;
    const double numeric =
        (objective.evaluate(Q + step * P).total - objective.evaluate(Q - step * P).total) /
        (2 * step);
    EXPECT_NEAR(dot(objective.gradient(Q, at), P), numeric, 1e-5 * std::abs(numeric) + 1e-7);
}

TEST(OutlineBarrier, StopsAtContact) {
    const auto piece = narrowGap(0.4);
    const auto objective = objectiveOf(*piece, true);
    const Points2 Q = flatGrid(*piece);
    Points2 P = Points2::Zero(Q.rows(), 2);
    for (const int v : {2, 3}) {  // the right tooth's tip moves left
        P.row(v) << -1, 0;
    }
    const double step = objective.largestStep(Q, P, 10);
    EXPECT_NEAR(step, 0.4, 1e-12);  // its corner meets the other tooth's
    EXPECT_GT(isometric::SymmetricDirichlet(piece->mesh, piece->table).largestStep(Q, P, 10), 0.41);
}

TEST(SymmetricDirichlet, StepEndsWhereTheFirstTriangleLosesItsArea) {
    const auto piece = test::asPiece(test::planeGrid(1, 1, 1.0));
    const isometric::SymmetricDirichlet energy(piece->mesh, piece->table);
    const Points2 Q = flatGrid(*piece);
    for (int v = 0; v < 4; ++v) {
        Points2 P = Points2::Zero(4, 2);
        P.row(v) = Eigen::RowVector2d(0.5, 0.5) - Q.row(v);
        const double step = energy.largestStep(Q, P, 4);
        EXPECT_TRUE(std::isfinite(energy.energy(Q + 0.999 * step * P)));
        if (step < 4) {
            EXPECT_FALSE(std::isfinite(energy.energy(Q + 1.001 * step * P)));
        }
    }
    EXPECT_EQ(energy.largestStep(Q, Points2::Ones(4, 2), 4), 4);
}

TEST(LengthConstraints, RestoreTheLengthsByASmallMotion) {
    const auto piece = test::asPiece(test::planeGrid(8, 5, 1.0));
    const LengthConstraints constraints(piece->boundary,
                                        boundaryLengths3d(piece->mesh.V, piece->boundary));
    Points2 Q = shaken(*piece, 0.02);
    const Points2 before = Q;
    ASSERT_TRUE(constraints.restore(Q));
    EXPECT_LE(constraints.residual(Q).lpNorm<Eigen::Infinity>(), 1e-12);
    EXPECT_LE((Q - before).lpNorm<Eigen::Infinity>(), 0.2);
    Points2 again = Q;
    ASSERT_TRUE(constraints.restore(again));
    EXPECT_LE((again - Q).lpNorm<Eigen::Infinity>(), 1e-12);
}

/// An edge of a thousand millionth of the outline: its length has few digits in the ends'
/// coordinates, and must not keep the others from theirs.
TEST(LengthConstraints, RestoreBesideAVeryShortEdge) {
    MeshArrays mesh = test::planeGrid(8, 5, 100);
    const auto plain = test::asPiece(mesh);
    const int corner = plain->boundary[3];
    const int next = plain->boundary[4];
    mesh.V.row(next) = mesh.V.row(corner) + 3e-8 * (mesh.V.row(next) - mesh.V.row(corner));
    const auto piece = test::asPiece(mesh);
    const Eigen::VectorXd lengths = boundaryLengths3d(piece->mesh.V, piece->boundary);
    const LengthConstraints constraints(piece->boundary, lengths);
    Points2 Q = shaken(*piece, 1e-7);
    ASSERT_TRUE(constraints.restore(Q));
    EXPECT_LE(constraints.residual(Q).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(LengthConstraints, RefuseAnOutlineInOneLine) {
    const auto piece = test::asPiece(test::planeGrid(3, 3, 1.0));
    const LengthConstraints constraints(piece->boundary,
                                        boundaryLengths3d(piece->mesh.V, piece->boundary));
    Points2 Q = Points2::Zero(piece->mesh.V.rows(), 2);
    EXPECT_FALSE(constraints.restore(Q));
}

/// A vertex slides along an edge that turns: the straight step closes the gap, which its
/// first-order model keeps. The forces act on nothing else, and cancel each other.
TEST(IsometricObjective, OpensGapsThatAStepCloses) {
    Points2 Q(3, 2);
    Q << 0.5, 0.01, 1, 0, 0, 0;
    isometric::OutlineBarrier::Contact contact{0, 2, 1, 0.1, 1, 0.01, 0.5, {0, 1}};
    Points2 step(3, 2);
    step << 0.2, 0.05, 0, 0.1, 0, 0;  // the gap at the middle stays
    Points2 forces = Points2::Zero(3, 2);
    EXPECT_TRUE(isometric::OutlineBarrier::addOpeningForces({contact}, step, Q + step, forces));
    EXPECT_GT(forces(0, 1), 0);
    EXPECT_LT(forces(1, 1), 0);
    EXPECT_LT(forces(2, 1), 0);
    EXPECT_LE(forces.colwise().sum().norm(), 1e-12 * forces.norm());
    step(0, 0) = 0;
    forces.setZero();
    EXPECT_FALSE(isometric::OutlineBarrier::addOpeningForces({contact}, step, Q + step, forces));
    EXPECT_EQ(forces.norm(), 0);
}

}  // namespace
}  // namespace toile
