// SPDX-License-Identifier: GPL-3.0-or-later
// What takes an isometric descent down the long way: coarse pieces, single vertices, remembered
// steps, and the decision when to factorise anew.
#include "core/flatten/isometric/isometric_start.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/flatten/isometric/refactorisation_policy.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

std::shared_ptr<const Piece> cap() {
    return test::asPiece(test::sphericalCap(24, 100, 2.9));
}

Points2 onCircle(const Piece& piece) {
    const Progress progress;
    const auto circle = tutteOnCircle(piece, progress);
    EXPECT_TRUE(circle);
    return *circle;
}

double dirichletOf(const Piece& piece, const Points2& Q) {
    return isometric::SymmetricDirichlet(piece.mesh, piece.table).energy(Q);
}

TEST(Coarsening, KeepsTheBoundaryAndFlipsNothing) {
    const auto piece = cap();
    const Points2 Q = onCircle(*piece);
    const int inner = static_cast<int>(Q.rows()) - static_cast<int>(piece->boundary.size());
    const isometric::Coarsening coarse(piece->mesh, piece->table, piece->boundary, Q, inner / 5,
                                       Progress());
    EXPECT_LT(coarse.mesh().V.rows(), Q.rows() / 2);
    ASSERT_EQ(coarse.loops().vertices().size(), piece->boundary.size());
    const Points2 flat = coarse.restricted(Q);
    for (std::size_t i = 0; i < coarse.loops().vertices().size(); ++i) {
        EXPECT_EQ(coarse.mesh().V.row(coarse.loops().vertices()[i]),
                  piece->mesh.V.row(piece->boundary[i]));
        EXPECT_EQ(flat.row(coarse.loops().vertices()[i]), Q.row(piece->boundary[i]));
    }
    EXPECT_EQ(test::turnedTriangles(flat, coarse.mesh().F), 0);
    // A disk still: Euler's count.
    const EdgeTable table =
        buildEdgeTable(coarse.mesh().F, static_cast<int>(coarse.mesh().V.rows()));
    EXPECT_EQ(coarse.mesh().V.rows() - table.edges.rows() + coarse.mesh().F.rows(), 1);
}

TEST(Coarsening, ComesBackWithoutFlips) {
    const auto piece = cap();
    const Points2 Q = onCircle(*piece);
    const isometric::Coarsening coarse(piece->mesh, piece->table, piece->boundary, Q, 20,
                                       Progress());
    const auto back = coarse.prolonged(coarse.restricted(Q));
    ASSERT_TRUE(back);
    EXPECT_EQ(coarse.restricted(*back), coarse.restricted(Q));
    EXPECT_EQ(test::turnedTriangles(*back, piece->mesh.F), 0);
}

/// A plane's vertices lie among their rings as they did: mean value coordinates are exact there.
TEST(Coarsening, RestoresAPlane) {
    const auto piece = test::asPiece(test::planeGrid(12, 9, 10));
    const Points2 Q = piece->mesh.V.leftCols<2>();
    const isometric::Coarsening coarse(piece->mesh, piece->table, piece->boundary, Q, 10,
                                       Progress());
    EXPECT_LT(coarse.mesh().V.rows(), Q.rows());
    const auto back = coarse.prolonged(coarse.restricted(Q));
    ASSERT_TRUE(back);
    EXPECT_LE((*back - Q).lpNorm<Eigen::Infinity>(), 1e-9);
}

/// Forces on fine vertices do the same work along a fine motion as the restricted ones along the
/// coarse motion it comes from.
TEST(Coarsening, RestrictsForcesAsItProlongsMotions) {
    const auto piece = cap();
    const Points2 Q = onCircle(*piece);
    const isometric::Coarsening coarse(piece->mesh, piece->table, piece->boundary, Q,
                                       static_cast<int>(Q.rows()) / 6, Progress());
    const Eigen::Index few = coarse.mesh().V.rows();
    const Points2 motion = coarse.restricted(piece->mesh.V.rightCols<2>());
    const Points2 forces = piece->mesh.V.leftCols<2>().array().sin();
    const Points2 onCoarse = coarse.restrictedForces(forces);
    ASSERT_EQ(onCoarse.rows(), few);
    EXPECT_NEAR(onCoarse.cwiseProduct(motion).sum(),
                forces.cwiseProduct(coarse.prolongedMotion(motion)).sum(), 1e-9);
    // What moves as one goes on as one, and no force gets lost.
    EXPECT_LE((coarse.prolongedMotion(Points2::Ones(few, 2)) - Points2::Ones(Q.rows(), 2))
                  .lpNorm<Eigen::Infinity>(),
              1e-12);
    EXPECT_LE((onCoarse.colwise().sum() - forces.colwise().sum()).norm(), 1e-9);
}

TEST(IsometricStart, IsNearerToTheEndWithExactLengths) {
    const auto piece = cap();
    const Points2 Q = onCircle(*piece);
    const Progress progress;
    const isometric::IsometricStart start =
        isometric::coarseToFine(piece->mesh, piece->table, piece->boundary, Q, {}, progress);
    const auto lowest = isometric::lowerIsometricEnergy(piece->mesh, piece->table, piece->boundary,
                                                        Q, {}, progress);
    ASSERT_TRUE(lowest);
    EXPECT_LT(dirichletOf(*piece, start.Q) - lowest->distortion,
              0.8 * (dirichletOf(*piece, Q) - lowest->distortion));
    EXPECT_EQ(start.multipliers.size(), static_cast<Eigen::Index>(piece->boundary.size()));
    const LengthConstraints constraints(piece->boundary,
                                        boundaryLengths3d(piece->mesh.V, piece->boundary));
    EXPECT_LE(constraints.residual(start.Q).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST(IsometricStart, LeavesWhatIsHardlyStrained) {
    const auto piece = test::asPiece(test::planeGrid(30, 30, 10));
    const Points2 Q = piece->mesh.V.leftCols<2>();
    const Progress progress;
    EXPECT_EQ(
        isometric::coarseToFine(piece->mesh, piece->table, piece->boundary, Q, {}, progress).Q, Q);
}

TEST(SymmetricDirichlet, RelaxingLowersTheEnergyAndLeavesTheFixed) {
    const auto piece = cap();
    Points2 Q = onCircle(*piece);
    const Points2 before = Q;
    isometric::SymmetricDirichlet(piece->mesh, piece->table)
        .relax(Q, piece->boundary, 5, Progress());
    EXPECT_LT(dirichletOf(*piece, Q), dirichletOf(*piece, before));
    for (const int v : piece->boundary) {
        EXPECT_EQ(Q.row(v), before.row(v));
    }
}

/// On a quadratic function of two unknowns two steps tell all of the curvature.
TEST(LbfgsHistory, KnowsAQuadraticAfterAsManySteps) {
    Eigen::Matrix2d H;
    H << 5, 2, 2, 3;
    const auto asStep = [](const Eigen::Vector2d& p) -> Points2 { return p.transpose(); };
    isometric::LbfgsHistory memory;
    const Eigen::Vector2d first(1, 0);
    const Eigen::Vector2d second = Eigen::Vector2d(-2, 5);  // conjugate to the first
    memory.add(asStep(first), asStep(H * first));
    memory.add(asStep(second), asStep(H * second));
    memory.add(asStep(first), asStep(-first));  // says nothing: the gradient fell
    const Eigen::Vector2d gradient(0.7, -1.9);
    Points2 reduced = asStep(gradient);
    const auto taken = memory.reduce(reduced);
    Points2 step = -reduced;  // as by a poor inverse Hessian
    memory.complete(taken, step);
    const Eigen::Vector2d newton = -H.inverse() * gradient;
    EXPECT_LE((step.transpose() - newton).norm(), 1e-12);
}

constexpr double kFactorisingCost = 12;  // in steps

TEST(RefactorisationPolicy, StaysWithAFactorisationThatServes) {
    isometric::RefactorisationPolicy policy;
    EXPECT_TRUE(policy.isFresh());
    policy.count(1, 100, 100, kFactorisingCost);
    EXPECT_FALSE(policy.isFresh());
    policy.count(1, 10, 9, kFactorisingCost);  // more than 109 / 13
    EXPECT_FALSE(policy.isFresh());
    policy.count(1, 0.1, 0.09, kFactorisingCost);  // little, but as promised
    EXPECT_FALSE(policy.isFresh());
    policy.count(1, 0.1, 0.01, kFactorisingCost);  // little, and less than promised
    EXPECT_TRUE(policy.isFresh());
}

TEST(RefactorisationPolicy, RenewsSoonerWhatCostsLess) {
    for (const double cost : {1.0, kFactorisingCost}) {
        isometric::RefactorisationPolicy policy;
        policy.count(1, 100, 100, cost);
        policy.count(1, 100, 20, cost);
        EXPECT_EQ(policy.isFresh(), cost == 1);
    }
}

TEST(RefactorisationPolicy, DoesNotTakeAStoppedStepForTheEnd) {
    isometric::RefactorisationPolicy policy;
    policy.count(0.01, 5, 1e-6, kFactorisingCost);
    EXPECT_TRUE(policy.wasStopped());
    EXPECT_TRUE(policy.isFresh());
    EXPECT_FALSE(policy.hasArrived(1e-4));
    policy.count(1, 1e-5, 1e-5, kFactorisingCost);
    EXPECT_TRUE(policy.hasArrived(1e-4));
}

}  // namespace
}  // namespace toile
