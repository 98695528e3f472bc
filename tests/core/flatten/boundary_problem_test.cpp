// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/boundary_problem.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using std::numbers::pi;

BoundaryProblem problemOf(const Piece& piece) {
    return {boundaryLengths3d(piece.mesh.V, piece.boundary),
            boundaryAngles3d(piece.mesh, piece.boundary)};
}

/// Angles of a random but roughly convex outline with random edge lengths.
BoundaryProblem randomProblem(int n, unsigned seed, double roughness) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return random() / 4294967296.0; };
    BoundaryProblem problem{Eigen::VectorXd(n), Eigen::VectorXd(n)};
    for (int i = 0; i < n; ++i) {
        problem.lengths[i] = 0.2 + uniform();
        problem.angles[i] = pi - 2 * pi / n + roughness * (uniform() - 0.5);
    }
    return problem;
}

void expectClosedWithLengths(const BoundaryProblem& problem, const FlatBoundary& flat) {
    EXPECT_LE(flat.closureGap, kClosureTolerance);
    const auto n = static_cast<int>(problem.lengths.size());
    std::vector<int> loop(n);
    for (int i = 0; i < n; ++i) {
        loop[i] = i;
    }
    EXPECT_LE(maxRelativeLengthError(problem.lengths, boundaryLengths2d(flat.points, loop)), 1e-9);
    EXPECT_NEAR(flat.angles.sum(), (n - 2) * pi, 1e-9);
}

class BothSolvers : public testing::TestWithParam<BoundarySolver> {};

TEST_P(BothSolvers, ATriangleIsItsLengths) {
    BoundaryProblem problem{Eigen::Vector3d(3, 4, 5), Eigen::Vector3d(1.2, 1, 0.9)};
    const auto flat = solveBoundary(problem, GetParam(), Progress());
    ASSERT_TRUE(flat) << sentence(flat.error());
    expectClosedWithLengths(problem, *flat);
    EXPECT_NEAR(flat->angles[1], pi / 2, 1e-9);  // between the sides 3 and 4
}

TEST_P(BothSolvers, AClosedOutlineStaysAsItIs) {
    const auto piece = test::asPiece(test::planeGrid(5, 3, 12));
    const BoundaryProblem problem = problemOf(*piece);
    const auto flat = solveBoundary(problem, GetParam(), Progress());
    ASSERT_TRUE(flat);
    expectClosedWithLengths(problem, *flat);
    EXPECT_LE((flat->angles - problem.angles).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LE(flat->iterations, 1);
}

TEST_P(BothSolvers, MeetsTheOptimalityCondition) {
    // At the optimum theta - alpha is an affine function of the vertex's place in the plane.
    const BoundaryProblem problem = randomProblem(60, 11, 0.3);
    const auto flat = solveBoundary(problem, GetParam(), Progress());
    ASSERT_TRUE(flat) << sentence(flat.error());
    expectClosedWithLengths(problem, *flat);
    Eigen::MatrixXd affine(60, 3);
    affine << Eigen::VectorXd::Ones(60), flat->points;
    const Eigen::VectorXd correction = flat->angles - problem.angles;
    const Eigen::VectorXd fit = affine.colPivHouseholderQr().solve(correction);
    EXPECT_LE((affine * fit - correction).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_P(BothSolvers, AnyScaleGivesTheSameShape) {
    const BoundaryProblem unit = randomProblem(40, 3, 0.2);
    const auto reference = solveBoundary(unit, GetParam(), Progress());
    ASSERT_TRUE(reference);
    for (const double scale : {1e-7, 1e-3, 1e6}) {
        const BoundaryProblem scaled{scale * unit.lengths, unit.angles};
        const auto flat = solveBoundary(scaled, GetParam(), Progress());
        ASSERT_TRUE(flat) << scale;
        expectClosedWithLengths(scaled, *flat);
        EXPECT_LE((flat->points / scale - reference->points).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST_P(BothSolvers, RefusesAnEdgeAsLongAsAllOthers) {
    for (const double length : {2.0, 5.0}) {
        const BoundaryProblem problem{Eigen::Vector3d(1, 1, length), Eigen::Vector3d(1, 1, 1)};
        const auto flat = solveBoundary(problem, GetParam(), Progress());
        ASSERT_FALSE(flat);
        EXPECT_EQ(flat.error().code, ErrorCode::NoClosedOutline);
    }
}

TEST_P(BothSolvers, StopsWhenCancelledAndRefusesWhatIsNotFinite) {
    Progress cancelled;
    cancelled.cancel();
    const auto flat = solveBoundary(randomProblem(30, 1, 0.2), GetParam(), cancelled);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::Cancelled);
    BoundaryProblem broken = randomProblem(30, 1, 0.2);
    broken.lengths[3] = std::nan("");
    EXPECT_EQ(solveBoundary(broken, GetParam(), Progress()).error().code, ErrorCode::NotFinite);
}

TEST_P(BothSolvers, ClosesTheCubeSlitAlongOneEdge) {
    // From raw angles [Wang05]'s iteration ends in a wrong outline here (paper_iteration_test.cpp).
    const auto piece = test::asPiece(test::cubeSlitAlongOneEdge());
    ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
    const BoundaryProblem problem = problemOf(*piece);
    const auto flat = solveBoundary(problem, GetParam(), Progress());
    ASSERT_TRUE(flat) << sentence(flat.error());
    expectClosedWithLengths(problem, *flat);
}

INSTANTIATE_TEST_SUITE_P(Solvers, BothSolvers,
                         testing::Values(BoundarySolver::Newton, BoundarySolver::Slcp),
                         [](const auto& shown) { return std::string(name(shown.param)); });

TEST(BoundaryProblem, BothSolversFindTheSameOutline) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const BoundaryProblem problem = randomProblem(10 + 7 * static_cast<int>(seed), seed, 0.4);
        const auto newton = solveBoundary(problem, BoundarySolver::Newton, Progress());
        const auto slcp = solveBoundary(problem, BoundarySolver::Slcp, Progress());
        ASSERT_TRUE(newton && slcp) << seed;
        EXPECT_LE((newton->angles - slcp->angles).cwiseAbs().maxCoeff(), 1e-9) << seed;
    }
}

TEST_P(BothSolvers, SolvesEveryRoughOutline) {
    // Far rougher than any garment: corners wanted up to 86 degrees off at random.
    for (unsigned seed = 0; seed < 600; ++seed) {
        const BoundaryProblem problem = randomProblem(4 + static_cast<int>(seed % 80), seed, 3.0);
        const auto flat = solveBoundary(problem, GetParam(), Progress());
        ASSERT_TRUE(flat) << seed << ": " << sentence(flat.error());
        expectClosedWithLengths(problem, *flat);
        EXPECT_LE((flat->angles - problem.angles).cwiseAbs().maxCoeff(), 2 * pi) << seed;
    }
}

TEST(BoundaryProblem, DescentFromTheCircleNeverFails) {
    // Edges of four orders of magnitude, angles wanted far beyond what a corner can have.
    std::mt19937 random(4);
    const auto uniform = [&] { return random() / 4294967296.0; };
    for (int trial = 0; trial < 1000; ++trial) {
        const int n = 3 + trial % 80;
        const double roughness = 6 * uniform();
        BoundaryProblem problem{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (int i = 0; i < n; ++i) {
            problem.lengths[i] = std::pow(10, 4 * uniform());
            problem.angles[i] = pi - 2 * pi / n + roughness * (uniform() - 0.5);
        }
        problem.lengths /= problem.lengths.sum();
        if (problem.lengths.maxCoeff() < 0.5) {
            const auto flat = solveBoundaryDescent(problem, Progress());
            ASSERT_TRUE(flat) << trial << ": " << sentence(flat.error());
            expectClosedWithLengths(problem, *flat);
        }
    }
}

TEST(BoundaryProblem, DescentAgreesWhereTheOthersConverge) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        BoundaryProblem problem = randomProblem(10 + 7 * static_cast<int>(seed), seed, 0.4);
        problem.lengths /= problem.lengths.sum();
        const auto newton = solveBoundaryNewton(problem, Progress());
        const auto descent = solveBoundaryDescent(problem, Progress());
        ASSERT_TRUE(newton && descent) << seed;
        EXPECT_LE((newton->angles - descent->angles).cwiseAbs().maxCoeff(), 1e-9) << seed;
    }
}

TEST_P(BothSolvers, TakesTheOutlineOfLowerEnergy) {
    // A minimum in which the outline winds backwards at two corners lies near this start.
    const BoundaryProblem problem{Eigen::Vector4d(0.0119485, 0.483318, 0.5125, 0.129945),
                                  Eigen::Vector4d(1.53739, 1.68801, 1.52272, 1.5976)};
    const auto flat = solveBoundary(problem, GetParam(), Progress());
    ASSERT_TRUE(flat);
    EXPECT_NEAR(flat->energy, 1.389, 1e-3);
}

TEST(BoundaryProblem, NewtonHandlesAHundredThousandEdges) {
    const BoundaryProblem problem = randomProblem(100000, 2, 1e-3);
    const auto flat = solveBoundary(problem, BoundarySolver::Newton, Progress());
    ASSERT_TRUE(flat) << sentence(flat.error());
    expectClosedWithLengths(problem, *flat);
    EXPECT_LE(flat->iterations, 12);
}

}  // namespace
}  // namespace toile
