// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "tests/core/pattern/fair_shapes.h"

namespace toile {
namespace {

using Eigen::Vector2d;

using std::numbers::pi;

/// A line that turns as told along its way, in chords of 2 mm.
Points2 turning(double length, const std::function<double(double)>& direction) {
    const int steps = static_cast<int>(std::lround(length / 2));
    Points2 points(steps + 1, 2);
    points.row(0).setZero();
    for (int k = 0; k < steps; ++k) {
        const double phi = direction((k + 0.5) * length / steps);
        points.row(k + 1) =
            points.row(k) + length / steps * Eigen::RowVector2d(std::cos(phi), std::sin(phi));
    }
    return points;
}

Points2 arc(double radius, double angle) {
    return turning(radius * angle, [&](double way) { return way / radius; });
}

double chordLength(const Points2& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1))
        .rowwise()
        .norm()
        .sum();
}

std::vector<double> waysOf(const Points2& line) {
    std::vector<double> ways{0};
    for (Eigen::Index k = 1; k < line.rows(); ++k) {
        ways.push_back(ways.back() + (line.row(k) - line.row(k - 1)).norm());
    }
    return ways;
}

/// How far points of a line are from another that runs beside it: the nearest place is looked for
/// within some millimetres of the same way along both.
double farthest(const Points2& points, const Points2& line) {
    constexpr double kBeside = 5;
    const std::vector<double> ways = waysOf(points), along = waysOf(line);
    double far = 0;
    Eigen::Index first = 0;
    for (Eigen::Index p = 0; p < points.rows(); ++p) {
        const Vector2d point = points.row(p);
        while (first + 2 < line.rows() && along[first + 1] < ways[p] - kBeside) {
            ++first;
        }
        double nearest = 1e300;
        for (Eigen::Index k = first; k + 1 < line.rows() && along[k] <= ways[p] + kBeside; ++k) {
            const Vector2d a = line.row(k), b = line.row(k + 1);
            nearest = std::min(nearest,
                               (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
        }
        far = std::max(far, nearest);
    }
    return far;
}

/// A quarter of a millimetre apart, about.
Points2 fineSamples(const std::vector<CubicCurve>& chain) {
    double longest = 4;
    for (const CubicCurve& curve : chain) {
        longest = std::max(longest, curveLength(curve));
    }
    return sampled(chain, static_cast<int>(std::ceil(4 * longest)));
}

void expectFits(const Points2& line, const std::vector<CubicCurve>& chain,
                double tolerance = kCurveTolerance) {
    ASSERT_FALSE(chain.empty());
    EXPECT_EQ(chain.front().start, Vector2d(line.row(0)));
    EXPECT_EQ(chain.back().end, Vector2d(line.row(line.rows() - 1)));
    for (std::size_t k = 1; k < chain.size(); ++k) {
        EXPECT_EQ(chain[k].start, chain[k - 1].end);
        EXPECT_NEAR(geometry::turnBetween(chain[k - 1].derivative(1), chain[k].derivative(0)), 0,
                    1e-9);
    }
    const Points2 fine = fineSamples(chain);
    EXPECT_LT(farthest(fine, line), tolerance);
    EXPECT_LT(farthest(line, fine), kCurveTolerance);
    EXPECT_NEAR(curveLength(chain), chordLength(line), kCurveLengthTolerance);
}

TEST(CubicCurve, LengthIsThatOfManyChords) {
    const CubicCurve curve{{0, 0}, {30, 0}, {60, 20}, {60, 55}};
    EXPECT_NEAR(curveLength(curve), chordLength(sampled({curve}, 20000)), 1e-6);
    EXPECT_DOUBLE_EQ(curveLength(straightCurve({0, 0}, {3, 4})), 5);
}

TEST(CurveFit, StraightLineIsOneLine) {
    const Points2 line = turning(300, [](double) { return 0.3; });
    const auto chain = fitCurves(line, 300);
    ASSERT_EQ(chain.size(), 1U);
    EXPECT_TRUE(chain[0].isLine);
    expectFits(line, chain);
}

TEST(CurveFit, TwoPointsAreALine) {
    const Points2 line = turning(2, [](double) { return 0.0; });
    const auto chain = fitCurves(line, 2);
    ASSERT_EQ(chain.size(), 1U);
    EXPECT_TRUE(chain[0].isLine);
}

TEST(CurveFit, ArcsTakeFewCurves) {
    struct Case {
        double radius, angle;
        std::size_t most;
    };
    for (const Case& of : {Case{200, pi / 2, 2}, Case{200, 2 * pi, 6}, Case{1000, 0.5, 1},
                           Case{50, pi / 2, 3}, Case{30, pi, 3}}) {
        SCOPED_TRACE(testing::Message() << of.radius << " mm, " << of.angle);
        const Points2 line = arc(of.radius, of.angle);
        const auto chain = fitCurves(line, chordLength(line));
        EXPECT_LE(chain.size(), of.most);
        EXPECT_FALSE(chain.front().isLine);
        expectFits(line, chain);
    }
}

TEST(CurveFit, BendsToBothSides) {
    for (const double waves : {1.0, 2.0, 5.0}) {
        const Points2 line =
            turning(500, [&](double way) { return 0.4 * std::sin(2 * pi * waves * way / 500); });
        const auto chain = fitCurves(line, chordLength(line));
        EXPECT_LE(chain.size(), static_cast<std::size_t>(4 * waves));
        expectFits(line, chain);
    }
}

TEST(CurveFit, TightBendsKeepTheirLength) {
    const Points2 line = arc(20, 0.5 * pi);
    const auto chain = fitCurves(line, chordLength(line));
    EXPECT_LE(chain.size(), 3U);
    expectFits(line, chain, 0.032);  // an arc of 2 mm stands 0.025 mm off its chord
}

TEST(CurveFit, SpiralAndStraightEnds) {
    const Points2 line = turning(400, [](double way) {
        const double bent = std::clamp(way - 100, 0.0, 200.0);
        return 1e-5 * bent * bent * (3 - bent / 100);
    });
    const auto chain = fitCurves(line, chordLength(line));
    EXPECT_LE(chain.size(), 6U);
    expectFits(line, chain);
}

TEST(CurveFit, FollowsFairLines) {
    for (const double noise : {0.2, 0.5, 1.0}) {
        const FairProblem problem = test::noisyPolygon(test::rectangle(120, 180), noise, 1);
        const auto line = fairLine(problem, Progress());
        ASSERT_TRUE(line.ok());
        const Eigen::Index n = line->points.rows();
        std::size_t curves = 0;
        for (std::size_t c = 0; c < problem.corners.size(); ++c) {
            const Eigen::Index first = problem.corners[c].node;
            const Eigen::Index last =
                c + 1 < problem.corners.size() ? problem.corners[c + 1].node : n;
            Points2 segment(last - first + 1, 2);
            segment << line->points.middleRows(first, last - first), line->points.row(last % n);
            const double length = problem.steps.segment(first, last - first).sum();
            const auto chain = fitCurves(segment, length);
            expectFits(segment, chain);
            curves += chain.size();
        }
        EXPECT_LE(curves, 30U);
    }
}

TEST(CurveFit, RoughLinesTakeMoreCurvesAndFitAllTheSame) {
    std::vector<int> corners;
    const test::Outline rough =
        test::noisy(test::divided({{0, 0}, {60, 0}, {60, 40}, {0, 40}}, 2, corners), 0.2, 3);
    Points2 line(static_cast<Eigen::Index>(rough.size()), 2);
    for (std::size_t k = 0; k < rough.size(); ++k) {
        line.row(static_cast<Eigen::Index>(k)) = rough[k];
    }
    expectFits(line, fitCurves(line, chordLength(line)));
}

TEST(CurveFit, TurnsWithTheLine) {
    const Points2 line = turning(500, [](double way) { return 0.4 * std::sin(way / 60); });
    const Eigen::Rotation2Dd rotation(2.1);
    const Points2 turned = line * rotation.toRotationMatrix().transpose();
    const auto chain = fitCurves(line, 500), other = fitCurves(turned, 500);
    ASSERT_EQ(chain.size(), other.size());
    for (std::size_t k = 0; k < chain.size(); ++k) {
        EXPECT_LT((rotation * chain[k].startHandle - other[k].startHandle).norm(), 1e-6);
        EXPECT_LT((rotation * chain[k].endHandle - other[k].endHandle).norm(), 1e-6);
    }
}

}  // namespace
}  // namespace toile
