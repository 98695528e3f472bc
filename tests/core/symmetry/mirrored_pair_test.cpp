// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirrored_pair.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// An egg with waves, corners at uneven angles from `first` on; symmetric in the y axis for no
/// waves.
Points2 egg(int corners, double waves, double first = 0) {
    Points2 line(corners, 2);
    for (int k = 0; k < corners; ++k) {
        const double even = k + 0.3 * std::sin(1.7 * k);
        const double angle = first + kTurn * even / corners;
        const double radius = 100 + 20 * std::sin(angle) + waves * std::sin(5 * angle + 1);
        line.row(k) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return line;
}

/// Lengths of a closed line's edges.
Eigen::VectorXd edgesOf(const Points2& line) {
    const Eigen::Index n = line.rows();
    Eigen::VectorXd lengths(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        lengths[k] = (line.row((k + 1) % n) - line.row(k)).norm();
    }
    return lengths;
}

/// Length along a closed line from one row to another.
double lengthBetween(const Points2& line, int from, int to) {
    const Eigen::VectorXd lengths = edgesOf(line);
    double sum = 0;
    for (int k = from; k != to; k = (k + 1) % static_cast<int>(lengths.size())) {
        sum += lengths[k];
    }
    return sum;
}

double arcOf(const Points2& line, int corner) {
    return edgesOf(line).head(corner).sum();
}

void expectMirrorImages(const Points2& a, const Points2& b) {
    ASSERT_EQ(a.rows(), b.rows());
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
        const Eigen::Index other = (a.rows() - k) % a.rows();
        EXPECT_EQ(a(k, 0), -b(other, 0));
        EXPECT_EQ(a(k, 1), b(other, 1));
    }
}

/// Every edge of the given line is as long as before, measured along the new one.
void expectEdgesKept(const Points2& given, const Points2& line, const std::vector<int>& row) {
    const Eigen::VectorXd lengths = edgesOf(given);
    for (std::size_t k = 0; k < row.size(); ++k) {
        const double length = lengths[static_cast<Eigen::Index>(k)];
        EXPECT_NEAR(lengthBetween(line, row[k], row[(k + 1) % row.size()]), length, 1e-9);
    }
}

const Points2 kTriangle = (Points2(3, 2) << 0, 0, 40, 0, 10, 30).finished();

TEST(MirroredLine, TwiceIsTheLineItself) {
    const Points2 line = egg(31, 6);
    EXPECT_EQ(mirroredLine(mirroredLine(line, 0), 0), line);
    EXPECT_EQ(mirroredLine(line, 0).row(0), Eigen::RowVector2d(-line(0, 0), line(0, 1)));
}

TEST(MirroredLine, BeginsWhereItIsTold) {
    const Points2 atCorner = mirroredLine(kTriangle, 40);
    EXPECT_EQ(atCorner, (Points2(3, 2) << -40, 0, 0, 0, -10, 30).finished());
    const Points2 within = mirroredLine(kTriangle, 10);
    EXPECT_EQ(within, (Points2(4, 2) << -10, 0, 0, 0, -10, 30, -40, 0).finished());
}

TEST(MeanLine, OfALineAndItsMirrorImageIsTheLine) {
    const Points2 a = egg(40, 6);
    const Points2 b = mirroredLine(a, arcOf(a, 7));
    const auto pair = meanLine(a, b, {{arcOf(a, 7), 0}, {arcOf(a, 19), arcOf(b, 28)}});
    ASSERT_TRUE(pair);
    ASSERT_EQ(pair->a.rows(), 40);
    expectMirrorImages(pair->a, pair->b);
    Points2 found(40, 2);
    for (int k = 0; k < 40; ++k) {
        found.row(k) = pair->a.row(pair->rowOfA[static_cast<std::size_t>(k)]);
    }
    EXPECT_LT(test::distanceAfterRigidMotion(found, a), 1e-9);
}

/// Two outlines that are nearly mirror images, with corners at other places and equal halves.
struct Halves {
    Points2 a, b;
    std::vector<MirrorEnd> ends;
};

Halves unlike() {
    Halves halves{egg(40, 5), egg(53, -4, 0.3), {}};
    halves.b *= edgesOf(halves.a).sum() / edgesOf(halves.b).sum();
    const double half = 0.5 * edgesOf(halves.a).sum();
    const double at = arcOf(halves.b, 20);
    halves.ends = {{arcOf(halves.a, 5), at}, {arcOf(halves.a, 5) + half, at - half}};
    return halves;
}

TEST(MeanLine, KeepsEveryEdgeAlongTheLine) {
    const Halves halves = unlike();
    const auto pair = meanLine(halves.a, halves.b, halves.ends);
    ASSERT_TRUE(pair);
    expectMirrorImages(pair->a, pair->b);
    expectEdgesKept(halves.a, pair->a, pair->rowOfA);
    expectEdgesKept(halves.b, pair->b, pair->rowOfB);
    EXPECT_EQ(pair->rowOfA[5], 0);
    EXPECT_EQ(pair->rowOfB[20], 0);
}

TEST(MeanLine, DoesNotDependOnWhereTheLinesLie) {
    const Halves halves = unlike();
    const auto pair = meanLine(halves.a, halves.b, halves.ends);
    const Eigen::Rotation2Dd turn(0.8);
    const Points2 turned = halves.a * turn.toRotationMatrix();
    const auto other = meanLine(turned, halves.b.array() + 30, halves.ends);
    ASSERT_TRUE(pair && other);
    ASSERT_EQ(pair->a.rows(), other->a.rows());
    EXPECT_LT(test::distanceAfterRigidMotion(pair->a, other->a), 1e-8);
}

TEST(MeanLine, OfTheTwoInOppositeRolesIsTheMirrorImage) {
    const Halves halves = unlike();
    std::vector<MirrorEnd> swapped;
    for (const MirrorEnd& end : {halves.ends[0], halves.ends[1]}) {
        swapped.insert(swapped.begin(), {end.b, end.a});
    }
    const auto pair = meanLine(halves.a, halves.b, halves.ends);
    const auto other = meanLine(halves.b, halves.a, swapped);
    ASSERT_TRUE(pair && other);
    Points2 one(40, 2), two(40, 2);
    for (std::size_t k = 0; k < 40; ++k) {
        one.row(static_cast<Eigen::Index>(k)) = pair->a.row(pair->rowOfA[k]);
        two.row(static_cast<Eigen::Index>(k)) = other->b.row(other->rowOfB[k]);
    }
    EXPECT_LT(test::distanceAfterRigidMotion(one, two), 1e-8);
}

TEST(SymmetricLine, IsItsOwnMirrorImage) {
    const Points2 line = egg(40, 5);
    const double half = 0.5 * edgesOf(line).sum();
    const double from = arcOf(line, 31);
    const auto symmetric = symmetricLine(line, from, from - half);
    ASSERT_TRUE(symmetric);
    expectMirrorImages(symmetric->line, symmetric->line);
    expectEdgesKept(line, symmetric->line, symmetric->row);
    const Points2& found = symmetric->line;
    EXPECT_EQ(found.row(0), Eigen::RowVector2d(0, 0));
    EXPECT_EQ(found(found.rows() / 2, 0), 0);
    EXPECT_GT(found(found.rows() / 2, 1), 100);
}

TEST(SymmetricLine, OfASymmetricLineIsThatLine) {
    // The left half of an egg is made of the right one.
    const Points2 right = egg(24, 0, -std::numbers::pi / 2);
    Points2 line(24, 2);
    line.row(0) = right.row(0);
    line(0, 0) = 0;
    for (int k = 1; k < 12; ++k) {
        line.row(k) = right.row(k);
        line.row(24 - k) << -right(k, 0), right(k, 1);
    }
    line.row(12) << 0, 120;
    const auto symmetric = symmetricLine(line, 0, arcOf(line, 12));
    ASSERT_TRUE(symmetric);
    ASSERT_EQ(symmetric->line.rows(), 24);
    EXPECT_LT((symmetric->line.rowwise() + line.row(0) - line).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace toile
