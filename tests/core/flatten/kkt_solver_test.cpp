// SPDX-License-Identifier: GPL-3.0-or-later
// The isometric descent's steps with and without a factorisation of the whole matrix.
#include "core/flatten/isometric/kkt_solver.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/flatten/interior/interior.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

constexpr int kNone = std::numeric_limits<int>::max();
constexpr isometric::KktSizes kFactorised{kNone, kNone};
constexpr isometric::KktSizes kLarge{0, kNone};
constexpr isometric::KktSizes kHuge{0, 0};

/// A piece on a circle: strained much, and unevenly.
struct Strained {
    explicit Strained(const MeshArrays& mesh)
        : piece(test::asPiece(mesh)),
          lengths(boundaryLengths3d(piece->mesh.V, piece->boundary)),
          Q(*tutteOnCircle(*piece, Progress())),
          objective(piece->mesh, piece->table, piece->boundary, lengths, false),
          constraints(piece->boundary, lengths),
          at(objective.evaluate(Q)),
          multipliers(Eigen::VectorXd::LinSpaced(lengths.size(), -1e-3, 1e-3)) {}

    isometric::KktSolver solver(const isometric::KktSizes& sizes, const Progress& progress) const {
        return {piece->mesh, piece->table, lengths, constraints, false, sizes, progress};
    }
    isometric::ModelPoint point() const { return {Q, at, multipliers}; }

    std::shared_ptr<const Piece> piece;
    Eigen::VectorXd lengths;
    Points2 Q;
    isometric::IsometricObjective objective;
    LengthConstraints constraints;
    isometric::IsometricObjective::Value at;
    Eigen::VectorXd multipliers;
};

double innerProduct(const Points2& a, const Points2& b) {
    return a.cwiseProduct(b).sum();
}

/// Assembles the matrix and asks for one solution that is known.
TEST(TwoLevelSolver, ComesNearTheSolution) {
    Strained cap(test::sphericalCap(24, 100, 2.2));
    const Progress progress;
    isometric::TwoLevelSolver solver(cap.piece->mesh, cap.piece->table, cap.piece->boundary,
                                     cap.lengths, false, progress);
    linalg::BlockMatrix& K = cap.objective.hessian(cap.Q, cap.at).matrix;
    isometric::addSpring(K, cap.piece->boundary.front());
    const Eigen::VectorXd stiffness = isometric::lengthStiffness(K, cap.piece->boundary);
    isometric::addLengths(K, cap.constraints, cap.point(), stiffness, 1e-9);
    ASSERT_TRUE(solver.renew(K, cap.point(), stiffness, 1e-9));

    const Points2 known = (0.1 * cap.piece->mesh.V.leftCols<2>()).array().sin();
    const Points2 right = K.product(known);
    Points2 x = Points2::Zero(known.rows(), 2);
    double first = 0;
    ASSERT_TRUE(solver.solve(right, x, first));
    const Points2 error = x - known;
    const double left = innerProduct(error, K.product(error));
    EXPECT_LE(left, 1e-3 * innerProduct(known, right));
    // It can go on from there.
    ASSERT_TRUE(solver.solve(right, x, first));
    const Points2 nearer = x - known;
    EXPECT_LE(innerProduct(nearer, K.product(nearer)), 0.1 * left);
    // No force, no motion.
    x.setZero();
    first = 0;
    ASSERT_TRUE(solver.solve(Points2::Zero(x.rows(), 2), x, first));
    EXPECT_EQ(x.norm(), 0);
}

TEST(TwoLevelSolver, HasNoCoarsePieceOfThreeTriangles) {
    Strained few(test::sphericalCap(2, 100, 1));
    const Progress progress;
    isometric::TwoLevelSolver solver(few.piece->mesh, few.piece->table, few.piece->boundary,
                                     few.lengths, false, progress);
    linalg::BlockMatrix& K = few.objective.hessian(few.Q, few.at).matrix;
    const Eigen::VectorXd stiffness = isometric::lengthStiffness(K, few.piece->boundary);
    const auto ready = solver.renew(K, few.point(), stiffness, 1e-9);
    ASSERT_FALSE(ready);
    EXPECT_EQ(ready.error().code, ErrorCode::FactorisationFailed);
}

TEST(KktSolver, TakesTheSameStepEitherWay) {
    Strained cap(test::sphericalCap(24, 100, 2.2));
    const Progress progress;
    const Points2 right = -cap.objective.gradient(cap.Q, cap.at);
    const Points2 directions = cap.constraints.directions(cap.Q);
    Points2 steps[2];
    double promises[2] = {};
    for (const int way : {0, 1}) {
        isometric::KktSolver solver = cap.solver(way == 0 ? kFactorised : kHuge, progress);
        ASSERT_TRUE(solver.renew(cap.objective, cap.point()));
        Eigen::VectorXd y = Eigen::VectorXd::Zero(cap.lengths.size());
        const auto P = solver.solve(right, Eigen::VectorXd::Zero(y.size()), y);
        ASSERT_TRUE(P);
        EXPECT_LE(cap.constraints.along(directions, *P).lpNorm<Eigen::Infinity>(),
                  1e-3 * P->lpNorm<Eigen::Infinity>());
        steps[way] = *P;
        promises[way] = 0.5 * innerProduct(right, *P);
    }
    EXPECT_NEAR(promises[1], promises[0], 1e-3 * promises[0]);
    EXPECT_LE((steps[1] - steps[0]).norm(), 0.05 * steps[0].norm());
}

TEST(KktSolver, FactorisesWhereThereIsNoCoarsePiece) {
    Strained few(test::sphericalCap(2, 100, 1));
    const Progress progress;
    isometric::KktSolver solver = few.solver(kHuge, progress);
    const double cheap = solver.renewingCost();
    ASSERT_TRUE(solver.renew(few.objective, few.point()));
    EXPECT_GT(solver.renewingCost(), cheap);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(few.lengths.size());
    EXPECT_TRUE(
        solver.solve(-few.objective.gradient(few.Q, few.at), Eigen::VectorXd::Zero(y.size()), y));
}

TEST(KktSolver, FactorisesAfterAllWhereManyRoundsCameToPass) {
    Strained cap(test::sphericalCap(24, 100, 2.2));
    const Progress progress;
    const Points2 right = -cap.objective.gradient(cap.Q, cap.at);
    for (const bool huge : {false, true}) {
        isometric::KktSolver solver = cap.solver(huge ? kHuge : kLarge, progress);
        const double cheap = solver.renewingCost();
        for (int step = 0; step < 40; ++step) {
            ASSERT_TRUE(solver.renew(cap.objective, cap.point()));
            Eigen::VectorXd y = Eigen::VectorXd::Zero(cap.lengths.size());
            ASSERT_TRUE(solver.solve(right, Eigen::VectorXd::Zero(y.size()), y));
        }
        EXPECT_EQ(solver.renewingCost() == cheap, huge);
    }
}

TEST(KktSolver, EndsWhenCancelled) {
    Strained cap(test::sphericalCap(24, 100, 2.2));
    Progress progress;
    isometric::KktSolver solver = cap.solver(kHuge, progress);
    ASSERT_TRUE(solver.renew(cap.objective, cap.point()));
    progress.cancel();
    Eigen::VectorXd y = Eigen::VectorXd::Zero(cap.lengths.size());
    const auto P =
        solver.solve(-cap.objective.gradient(cap.Q, cap.at), Eigen::VectorXd::Zero(y.size()), y);
    ASSERT_FALSE(P);
    EXPECT_EQ(P.error().code, ErrorCode::Cancelled);
    const auto renewed = solver.renew(cap.objective, cap.point());
    ASSERT_FALSE(renewed);
    EXPECT_EQ(renewed.error().code, ErrorCode::Cancelled);
}

/// Both descents end at the same energy, with exact lengths and no flips, with a barrier or not;
/// and again with the same bits.
TEST(KktSolver, LeadsToTheSameEndEitherWay) {
    for (const MeshArrays& mesh : {test::sphericalCap(24, 100, 2.2), test::saddle(30, 100, 0.01)}) {
        for (const bool simple : {false, true}) {
            const Strained from(mesh);
            const Piece& piece = *from.piece;
            isometric::DescentOptions options;
            options.keepOutlineSimple = simple;
            const auto descend = [&](const isometric::KktSizes& sizes) -> isometric::DescentResult {
                options.sizes = sizes;
                const auto end = isometric::lowerIsometricEnergy(
                    piece.mesh, piece.table, piece.boundary, from.Q, options, Progress());
                EXPECT_TRUE(end);
                return *end;
            };
            const isometric::DescentResult direct = descend(kFactorised);
            const isometric::DescentResult lean = descend(kHuge);
            EXPECT_TRUE(lean.converged);
            EXPECT_NEAR(lean.distortion, direct.distortion, 0.002 * (direct.distortion - 1));
            EXPECT_LE(from.constraints.residual(lean.Q).lpNorm<Eigen::Infinity>(), 1e-9);
            EXPECT_EQ(test::turnedTriangles(lean.Q, piece.mesh.F), 0);
            EXPECT_EQ(descend(kHuge).Q, lean.Q);
        }
    }
}

}  // namespace
}  // namespace toile
