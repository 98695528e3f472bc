// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/flatten/boundary/boundary_problem.h"

namespace toile {
namespace {

Eigen::VectorXd lengthsOf(const Points2& outline) {
    const auto n = outline.rows();
    Eigen::VectorXd lengths(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        lengths[i] = (outline.row((i + 1) % n) - outline.row(i)).norm();
    }
    return lengths;
}

/// Twice the signed area of every corner; all positive: strictly convex, if it turns once.
double leastTurn(const Points2& outline) {
    const auto n = outline.rows();
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::RowVector2d a = outline.row((i + 1) % n) - outline.row(i);
        const Eigen::RowVector2d b = outline.row((i + 2) % n) - outline.row((i + 1) % n);
        least = std::min(least, (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm()));
    }
    return least;
}

/// Sum of the outer angles.
double turning(const Points2& outline) {
    const auto n = outline.rows();
    double sum = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::RowVector2d a = outline.row((i + 1) % n) - outline.row(i);
        const Eigen::RowVector2d b = outline.row((i + 2) % n) - outline.row((i + 1) % n);
        sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return sum;
}

void expectConvexWithLengths(const Eigen::VectorXd& lengths) {
    const auto outline = circleOutline(lengths);
    ASSERT_TRUE(outline) << sentence(outline.error());
    EXPECT_LE((lengthsOf(*outline) - lengths).cwiseAbs().maxCoeff(), 1e-13 * lengths.sum());
    EXPECT_GT(leastTurn(*outline), 0);
    EXPECT_NEAR(turning(*outline), 2 * std::numbers::pi, 1e-9);
}

TEST(CircleOutline, EqualEdgesGiveTheRegularPolygon) {
    for (const int n : {3, 4, 5, 12, 1000}) {
        SCOPED_TRACE(n);
        const Eigen::VectorXd lengths = Eigen::VectorXd::Constant(n, 2.5);
        expectConvexWithLengths(lengths);
        const Points2 outline = *circleOutline(lengths);
        const double radius = 1.25 / std::sin(std::numbers::pi / n);
        const Eigen::RowVector2d centre = outline.colwise().mean();
        EXPECT_LE(((outline.rowwise() - centre).rowwise().norm().array() - radius).abs().maxCoeff(),
                  1e-12 * radius);
    }
}

TEST(CircleOutline, ATriangleIsTheTriangle) {
    // A right angle has the centre on the longest edge, an obtuse one beyond it.
    for (const Eigen::Vector3d& lengths : {Eigen::Vector3d(3, 4, 5), Eigen::Vector3d(4, 5, 6),
                                           Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(4, 2, 3)}) {
        expectConvexWithLengths(lengths);
    }
    const Points2 right = *circleOutline(Eigen::Vector3d(3, 4, 5));
    EXPECT_NEAR((right.row(1) - right.row(0)).dot(right.row(2) - right.row(1)), 0, 1e-14);
}

TEST(CircleOutline, AnEdgeNearlyAsLongAsAllOthersLeavesAFlatArc) {
    for (const double missing : {0.5, 1e-2, 1e-4, 1e-8, 1e-10}) {
        SCOPED_TRACE(missing);
        Eigen::VectorXd lengths = Eigen::VectorXd::Ones(11);
        lengths[4] = 10 - missing;
        const auto outline = circleOutline(lengths);
        ASSERT_TRUE(outline) << sentence(outline.error());
        expectConvexWithLengths(lengths);
    }
}

TEST(CircleOutline, ANeedleIsNoTrouble) {
    // Two edges are nearly diameters: the arcsine of a number near one.
    for (const double foot : {1e-3, 1e-6, 1e-9}) {
        SCOPED_TRACE(foot);
        expectConvexWithLengths(Eigen::Vector3d(1, 1, foot));
    }
}

TEST(CircleOutline, WildlyDifferentLengths) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-5, 1);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        Eigen::VectorXd lengths(3 + round % 40);
        for (double& length : lengths) {
            length = std::pow(10, exponent(random));
        }
        if (lengths.maxCoeff() < 0.999 * (lengths.sum() - lengths.maxCoeff())) {
            expectConvexWithLengths(lengths);
        }
    }
}

TEST(CircleOutline, ManyEdges) {
    Eigen::VectorXd lengths(100000);
    for (Eigen::Index i = 0; i < lengths.size(); ++i) {
        lengths[i] = 1 + 0.9 * std::sin(0.37 * static_cast<double>(i));
    }
    expectConvexWithLengths(lengths);
}

TEST(CircleOutline, ScalesWithTheLengths) {
    Eigen::VectorXd lengths(6);
    lengths << 3, 1, 4, 1, 5, 9;
    const Points2 outline = *circleOutline(lengths);
    for (const double scale : {1e-9, 1e9}) {
        const Points2 scaled = *circleOutline(scale * lengths);
        EXPECT_LE((scaled / scale - outline).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(CircleOutline, AnEdgeAsLongAsAllOthersHasNoPolygon) {
    for (const Eigen::Vector3d& lengths :
         {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 1, 5), Eigen::Vector3d(0, 0, 0)}) {
        const auto outline = circleOutline(lengths);
        ASSERT_FALSE(outline);
        EXPECT_EQ(outline.error().code, ErrorCode::NoClosedOutline);
    }
}

}  // namespace
}  // namespace toile
