// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/pattern/fair_outline.h"
#include "tests/core/pattern/fair_shapes.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using test::noisyCircle;
using test::noisyPolygon;
using test::Outline;
using test::polygon;
using test::rectangle;

FairLine solved(const FairProblem& problem) {
    auto line = fairLine(problem, Progress());
    EXPECT_TRUE(line.ok());
    return line ? std::move(*line) : FairLine{};
}

/// What holds of every result, converged or not.
void expectPromises(const FairLine& line, const FairProblem& problem) {
    ASSERT_EQ(line.points.rows(), problem.reference.rows());
    EXPECT_LT(test::largestLengthError(line, problem), 1e-10 * problem.steps.sum());
    EXPECT_LT(test::largestCornerError(line, problem), 1e-12);
    const Eigen::VectorXd away = (line.points - problem.reference).rowwise().norm();
    EXPECT_TRUE((away.array() < problem.tolerance.array()).all()) << away.maxCoeff();
    EXPECT_DOUBLE_EQ(line.farthest, away.maxCoeff());
    EXPECT_LE(line.iterations, kMaxFairIterations);
}

TEST(FairLine, StraightSidesStay) {
    for (const Outline& outline :
         {Outline{{0, 0}, {300, 0}, {100, 200}}, rectangle(200, 200), rectangle(300, 450)}) {
        const FairProblem problem = polygon(outline);
        const FairLine line = solved(problem);
        EXPECT_TRUE(line.converged);
        EXPECT_LE(line.iterations, 5);
        EXPECT_LT(line.farthest, 1e-9);
        expectPromises(line, problem);
    }
}

TEST(FairLine, NoiseGoesWithinItsIterations) {
    struct Case {
        double noise;
        int iterations;
        double left;  // of the variation
    };
    for (const Case& of : {Case{0.2, 10, 0.01}, Case{0.5, 12, 0.05}, Case{1, 30, 0.2}}) {
        for (const unsigned seed : {1U, 2U, 3U}) {
            SCOPED_TRACE(testing::Message() << of.noise << " mm, seed " << seed);
            const FairProblem problem = noisyPolygon(rectangle(300, 450), of.noise, seed);
            const FairLine line = solved(problem);
            EXPECT_TRUE(line.converged);
            EXPECT_LE(line.iterations, of.iterations);
            EXPECT_LT(test::variation(line.points, problem),
                      of.left * test::variation(problem.reference, problem));
            expectPromises(line, problem);
        }
    }
}

TEST(FairLine, MoreThanTheToleranceCanTakeIsStillExact) {
    for (const double noise : {2.0, 3.0}) {
        const FairProblem problem = noisyPolygon(rectangle(300, 450), noise, 1);
        expectPromises(solved(problem), problem);
    }
    std::vector<int> corners;
    const Outline rough = test::noisy(test::divided(rectangle(200, 100), 2, corners), 0.5, 1);
    const FairProblem problem = test::fairProblem(rough, corners, 1);
    expectPromises(solved(problem), problem);
}

TEST(FairLine, OutlineWithoutCornersBecomesNearlyACircle) {
    const FairProblem problem = noisyCircle(200, 0.5, 1);
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    EXPECT_LE(line.iterations, 30);
    EXPECT_LT(test::variation(line.points, problem),
              0.05 * test::variation(problem.reference, problem));
    expectPromises(line, problem);
}

TEST(FairLine, DartsAndShortSegmentsStay) {
    const Outline dart{{0, 0},   {100, 0}, {109, 120}, {109.001, 120},
                       {118, 0}, {220, 0}, {220, 300}, {0, 300}};
    const Outline tabs{{0, 0}, {3, 0}, {3, 3}, {100, 3}, {100, 0}, {103, 0}, {103, 100}, {0, 100}};
    for (const Outline& outline : {dart, tabs}) {
        const FairProblem problem = polygon(outline);
        const FairLine line = solved(problem);
        EXPECT_TRUE(line.converged);
        EXPECT_LE(line.iterations, 5);
        EXPECT_LT(line.farthest, 1e-9);
        expectPromises(line, problem);
    }
    const FairProblem problem = noisyPolygon(dart, 0.2, 1);
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    expectPromises(line, problem);
}

TEST(FairLine, CuspTurnsTheWayItIsTold) {
    FairProblem problem =
        polygon({{0, 0}, {100, 0}, {100, 120}, {100, 0.001}, {220, 0}, {220, 300}, {0, 300}});
    problem.corners[2].turn = std::numbers::pi - 1e-3;
    const FairLine line = solved(problem);
    EXPECT_LT(test::largestLengthError(line, problem), 1e-7);
    const int node = problem.corners[2].node;
    EXPECT_NEAR(line.directions[node] - line.directions[node - 1], problem.corners[2].turn, 1e-12);
}

TEST(FairLine, CornersTurnAsAsked) {
    FairProblem problem = noisyPolygon(rectangle(300, 450), 0.2, 1);
    problem.corners[1].turn += 0.01;
    problem.corners[2].turn -= 0.01;
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    expectPromises(line, problem);
}

TEST(FairLine, ChordsShorterThanTheStepsWillDo) {
    // The line is to be half a per mille longer than its reference: that shows as a bulge.
    FairProblem problem = polygon(rectangle(300, 450));
    problem.steps.head(150) *= 1.00005;
    problem.steps.segment(375, 150) *= 1.00005;
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    EXPECT_GT(line.farthest, 0.005);
    expectPromises(line, problem);
}

TEST(FairLine, StraightRunsHaveNoCurvature) {
    // Waves on half of the third side; straight are the first, and the rest of the third.
    const FairProblem plain = polygon(rectangle(300, 450));
    Outline bowed;
    for (Eigen::Index j = 0; j < plain.reference.rows(); ++j) {
        const double x = plain.reference(j, 0), y = plain.reference(j, 1);
        const double bow = y > 449 && x < 150 ? 0.5 * (1 - std::cos(x * std::numbers::pi / 25)) : 0;
        bowed.emplace_back(x, y + bow);
    }
    std::vector<int> corners;
    for (const FairProblem::Corner& corner : plain.corners) {
        corners.push_back(corner.node);
    }
    FairProblem problem = test::fairProblem(bowed, corners, 1);
    const int third = corners[2];
    problem.straight = {{corners[0], corners[1]}, {third, third + 70}};
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    expectPromises(line, problem);
    for (const FairProblem::Run& run : problem.straight) {
        for (int j = run.first + 1; j < run.last; ++j) {
            EXPECT_NEAR(line.directions[j], line.directions[j - 1], 1e-13);
        }
    }
}

TEST(FairLine, TurnsWithTheReference) {
    const FairProblem problem = noisyPolygon(rectangle(300, 450), 0.5, 1);
    FairProblem turned = problem;
    const Eigen::Rotation2Dd rotation(2.1);
    const Vector2d shift(40, -70);
    const auto move = [&](const Points2& points) -> Points2 {
        return (points * rotation.toRotationMatrix().transpose()).rowwise() + shift.transpose();
    };
    turned.reference = move(problem.reference);
    const FairLine line = solved(problem), other = solved(turned);
    EXPECT_LT((other.points - move(line.points)).rowwise().norm().maxCoeff(), 1e-8);
    EXPECT_EQ(line.iterations, other.iterations);
}

TEST(FairLine, IsTheSameInAMirror) {
    const FairProblem problem = noisyPolygon(rectangle(300, 450), 0.5, 1);
    // Node j becomes node n - j, step j becomes step n - 1 - j.
    const int n = static_cast<int>(problem.steps.size());
    FairProblem mirrored = problem;
    for (int j = 0; j < n; ++j) {
        mirrored.reference.row(j) = problem.reference.row((n - j) % n);
        mirrored.reference(j, 0) *= -1;
        mirrored.steps[j] = problem.steps[n - 1 - j];
    }
    mirrored.corners.clear();
    for (const FairProblem::Corner& corner : problem.corners) {
        mirrored.corners.push_back({(n - corner.node) % n, corner.turn});
    }
    const FairLine line = solved(problem), other = solved(mirrored);
    for (int j = 0; j < n; ++j) {
        const Vector2d there(-other.points((n - j) % n, 0), other.points((n - j) % n, 1));
        EXPECT_LT((line.points.row(j).transpose() - there).norm(), 1e-8);
    }
}

TEST(FairLine, GrowsWithItsLengths) {
    const FairProblem problem = noisyPolygon(rectangle(300, 450), 0.5, 1);
    FairProblem large = problem;
    large.reference *= 3;
    large.steps *= 3;
    large.tolerance *= 3;
    large.smoothing *= 3;
    const FairLine line = solved(problem), other = solved(large);
    EXPECT_LT((other.points - 3 * line.points).rowwise().norm().maxCoeff(), 1e-8);
    EXPECT_EQ(line.iterations, other.iterations);
}

TEST(FairLine, TighterToleranceHoldsNearer) {
    FairProblem problem = noisyPolygon(rectangle(300, 450), 0.2, 1);
    problem.tolerance.head(problem.tolerance.size() / 2).setConstant(0.2);
    const FairLine line = solved(problem);
    EXPECT_TRUE(line.converged);
    expectPromises(line, problem);
}

TEST(FairLine, SaysWhatItCannotWorkWith) {
    FairProblem problem = polygon(rectangle(300, 450));
    problem.reference(7, 1) = std::numeric_limits<double>::quiet_NaN();
    const auto broken = fairLine(problem, Progress());
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ErrorCode::NotFinite);
    Progress progress;
    progress.cancel();
    const auto cancelled = fairLine(polygon(rectangle(300, 450)), progress);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
}

TEST(FairLine, LengthsComeBeforeTheTolerance) {
    FairProblem problem = polygon(rectangle(300, 450));
    problem.steps *= 1.1;
    const FairLine line = solved(problem);
    EXPECT_FALSE(line.converged);
    EXPECT_LE(line.iterations, kMaxFairIterations);
    EXPECT_LT(test::largestLengthError(line, problem), 1e-9);
    EXPECT_LT(test::largestCornerError(line, problem), 1e-12);
    EXPECT_GT(line.farthest, 10);
}

}  // namespace
}  // namespace toile
