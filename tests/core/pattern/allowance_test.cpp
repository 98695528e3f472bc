// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "core/pattern/piece_allowance.h"
#include "tests/core/pattern/allowance_shapes.h"

namespace toile {
namespace {

using Eigen::RowVector2d;
using test::AllowanceCase;
using Polyline = std::vector<RowVector2d>;

constexpr double kExact = 1e-4;  // mm

Points2 asPoints(const Polyline& line) {
    Points2 points(line.size(), 2);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        points.row(k) = line[k];
    }
    return points;
}

/// The whole of the polyline lies on the cutting line.
void expectOn(const Points2& cut, const Polyline& line) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        for (const double share : {0.0, 0.3, 0.6, 1.0}) {
            const RowVector2d at = line[k] + share * (line[k + 1] - line[k]);
            EXPECT_LE(test::distanceTo(at, cut), kExact) << k << ": " << at;
        }
    }
}

TEST(CuttingLine, OfARegularPolygonIsOneWithTheSameSides) {
    constexpr int kSides = 200;
    constexpr double kInner = 100, kWidth = 10;  // inner radius
    Points2 seamLine(kSides, 2);
    for (int k = 0; k < kSides; ++k) {
        const double at = 2 * std::numbers::pi * k / kSides;
        seamLine.row(k) =
            kInner / std::cos(std::numbers::pi / kSides) * RowVector2d(std::cos(at), std::sin(at));
    }
    const Points2 cut = cuttingLine(seamLine, {{0, kWidth}});
    ASSERT_EQ(cut.rows(), kSides);
    for (int k = 0; k < kSides; ++k) {
        EXPECT_NEAR(cut.row(k).norm() * std::cos(std::numbers::pi / kSides), kInner + kWidth,
                    kExact);
        const RowVector2d middle = (cut.row(k) + cut.row((k + 1) % kSides)) / 2;
        EXPECT_NEAR(middle.norm(), kInner + kWidth, kExact);
    }
}

TEST(CuttingLine, OfARectangleIsALargerOne) {
    const Points2 seamLine = asPoints({{0, 0}, {300, 0}, {300, 200}, {0, 200}});
    const Points2 cut = cuttingLine(seamLine, {{0, 30}, {1, 10}, {2, 12}, {3, 0}});
    const Points2 expected = asPoints({{0, -30}, {310, -30}, {310, 212}, {0, 212}});
    EXPECT_EQ(cut.rows(), 4);
    EXPECT_LE(test::apart(cut, expected), kExact);
    EXPECT_NEAR(test::areaOf(cut), 310 * 242, 1);
}

TEST(CuttingLine, IsTheSeamLineWithoutAllowance) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Points2 seamLine = test::randomAllowances(seed).seamLine;
        EXPECT_LE(test::apart(cuttingLine(seamLine, {{0, 0}}), seamLine), kExact) << seed;
    }
}

/// A corner in the origin with long sides of two widths and a given turn; the piece's other sides
/// have none. First along x.
struct Corner {
    double turn, a, b;
    RowVector2d u{1, 0}, m{0, -1};
    RowVector2d v{std::cos(turn), std::sin(turn)}, n{std::sin(turn), -std::cos(turn)};
    double s = std::sin(turn), c = std::cos(turn);

    Points2 cut(CornerRule rule) const {
        const Polyline line =
            s > 0 ? Polyline{-400 * u, {0, 0}, 400 * v}
                  : Polyline{-400 * u, {0, 0}, 400 * v, {900, -500}, {900, 900}, {-400, 900}};
        return cuttingLine(asPoints(line), {{0, a}, {1, b, rule}, {2, 0}});
    }
    /// Where both cutting lines meet.
    RowVector2d tip() const { return a * m + (b - a * c) / s * u; }
    /// Along the first cutting line, then these, then the second.
    Polyline by(Polyline places) const {
        places.insert(places.begin(), -150 * u + a * m);
        places.push_back(150 * v + b * n);
        return places;
    }
};

class CornersOfCuttingLines
    : public testing::TestWithParam<std::tuple<int, std::pair<double, double>>> {
protected:
    Corner corner() const {
        const auto [degrees, widths] = GetParam();
        return {std::numbers::pi * (180 - degrees) / 180, widths.first, widths.second};
    }
    /// Either cutting line meets the other beyond its own edge.
    static bool canBeMitred(const Corner& k) { return k.b >= k.a * k.c && k.a >= k.b * k.c; }
};

INSTANTIATE_TEST_SUITE_P(
    Angles, CornersOfCuttingLines,
    testing::Combine(testing::Values(45, 60, 90, 135),
                     testing::Values(std::pair(10.0, 10.0), std::pair(30.0, 10.0),
                                     std::pair(10.0, 30.0), std::pair(20.0, 15.0))));

TEST_P(CornersOfCuttingLines, AreMitred) {
    const Corner k = corner();
    if (canBeMitred(k) && k.tip().norm() < kMitreLimit * std::max(k.a, k.b)) {
        expectOn(k.cut(CornerRule::Mitre), k.by({k.tip()}));
    } else if (k.a > k.b && k.c > 0) {  // the wider one ends at right angles
        expectOn(k.cut(CornerRule::Mitre), k.by({k.a * k.m, k.b / k.c * k.m}));
    }
}

TEST_P(CornersOfCuttingLines, AreSquare) {
    const Corner k = corner();
    if (!canBeMitred(k)) {
        return;
    }
    const RowVector2d way = k.tip().normalized();
    const double width = std::max(k.a, k.b);
    const RowVector2d first = k.a * k.m + (width - k.a * k.m.dot(way)) / k.u.dot(way) * k.u;
    const RowVector2d second = k.b * k.n - (width - k.b * k.n.dot(way)) / -k.v.dot(way) * k.v;
    expectOn(k.cut(CornerRule::Square), k.by({first, second}));
}

TEST_P(CornersOfCuttingLines, EndAtRightAngles) {
    const Corner k = corner();
    if (k.a >= k.b * k.c) {  // else the second sticks out beyond the first
        const RowVector2d root = k.b / k.s * k.u;
        expectOn(k.cut(CornerRule::RightAngleFirst), k.by({root + k.a * k.m, root}));
    }
    if (k.b >= k.a * k.c) {
        const RowVector2d root = -k.a / k.s * k.v;
        expectOn(k.cut(CornerRule::RightAngleSecond), k.by({root, root + k.b * k.n}));
    }
}

TEST_P(CornersOfCuttingLines, FoldBackOntoThePiece) {
    const Corner k = corner();
    const double most = kMitreLimit * std::max(k.a, k.b);
    const double end = (k.b + k.a * k.c) / k.s;
    if (k.a >= k.b * k.c && k.b / k.s <= most && std::hypot(end, k.a) <= most) {
        const RowVector2d root = k.b / k.s * k.u, tip = end * k.u + k.a * k.m;
        expectOn(k.cut(CornerRule::MirrorFirst), k.by({tip, root}));
        const RowVector2d folded(tip.x(), -tip.y());  // about the first seam line
        EXPECT_NEAR(folded.dot(k.n), k.b, 1e-9);      // on the second cutting line
    }
    const double other = (k.a + k.b * k.c) / k.s;
    if (k.b >= k.a * k.c && k.a / k.s <= most && std::hypot(other, k.b) <= most) {
        const RowVector2d root = -k.a / k.s * k.v, tip = -other * k.v + k.b * k.n;
        expectOn(k.cut(CornerRule::MirrorSecond), k.by({root, tip}));
    }
}

TEST_P(CornersOfCuttingLines, AreStepped) {
    const Corner k = corner();
    const double narrow = std::min(k.a, k.b);
    const Corner inner{k.turn, narrow, narrow};
    if (inner.tip().norm() > kMitreLimit * narrow) {
        return;  // cut off
    }
    Polyline places{inner.tip()};
    if (k.b < k.a * k.c) {
        places = {k.a * k.m, k.b / k.c * k.m};
    } else if (k.a < k.b * k.c) {
        places = {k.a / k.c * k.n, k.b * k.n};
    } else if (k.a > k.b) {
        places = {k.a * k.m, k.b * k.m, inner.tip()};
    } else if (k.b > k.a) {
        places = {inner.tip(), k.a * k.n, k.b * k.n};
    }
    expectOn(k.cut(CornerRule::Stepped), k.by(places));
}

TEST_P(CornersOfCuttingLines, DoNotDependOnHowSidesAreDivided) {
    const Corner k = corner();
    Polyline line;
    for (int at = 0; at < 100; ++at) {
        line.push_back((4.0 * at - 400) * k.u);
    }
    for (int at = 0; at < 100; ++at) {
        line.push_back(4.0 * at * k.v);
    }
    line.push_back(400 * k.v);
    for (int rule = 0; rule < 7; ++rule) {
        const auto corner = static_cast<CornerRule>(rule);
        const Points2 cut = cuttingLine(asPoints(line), {{0, k.a}, {100, k.b, corner}, {200, 0}});
        EXPECT_LE(test::apart(cut, k.cut(corner)), kExact) << rule;
        EXPECT_LE(cut.rows(), 12 + static_cast<int>(line.size())) << rule;
    }
}

TEST(CuttingLine, IsTheSameByAllRulesAtAConcaveCorner) {
    for (const double degrees : {200.0, 270.0, 300.0}) {
        const Corner k{std::numbers::pi * (180 - degrees) / 180, 12, 10};
        for (int rule = 0; rule < 7; ++rule) {
            expectOn(k.cut(static_cast<CornerRule>(rule)), k.by({k.tip()}));
        }
    }
}

TEST(CuttingLine, StepsAtRightAnglesWhereWidthsMeetWithoutACorner) {
    const Points2 seamLine = asPoints({{0, 0}, {100, 0}, {200, 0}, {200, 100}, {0, 100}});
    for (int rule = 0; rule < 7; ++rule) {
        const auto corner = static_cast<CornerRule>(rule);
        const Points2 cut = cuttingLine(seamLine, {{0, 30}, {1, 10, corner}, {2, 0}});
        expectOn(cut, {{0, -30}, {100, -30}, {100, -10}, {200, -10}, {200, 0}});
    }
}

TEST(CuttingLine, IsCutOffAtASpike) {
    const double half = 100 * std::tan(std::numbers::pi / 360);  // one degree at the tip
    const Points2 seamLine = asPoints({{0, -half}, {100, 0}, {0, half}});
    const Points2 cut = cuttingLine(seamLine, {{0, 10}, {1, 10}, {2, 10}});
    EXPECT_NEAR(cut.col(0).maxCoeff(), 100 + kMitreLimit * 10, kExact);
    EXPECT_LT(cut.col(1).maxCoeff(), 12);
    EXPECT_EQ(test::troubleWith({seamLine, {{0, 10}, {1, 10}, {2, 10}}}, cut), "");
}

TEST(CuttingLine, HasNoPointFartherFromTheSeamLineThanTheLimit) {
    for (int degrees = 8; degrees < 180; degrees += 7) {
        for (const auto& [a, b] : {std::pair(10.0, 10.0), std::pair(30.0, 7.0),
                                   std::pair(10.0, 30.0), std::pair(30.0, 25.0)}) {
            const Corner k{std::numbers::pi * (180 - degrees) / 180, a, b};
            const Points2 seamLine = asPoints({-400 * k.u, {0, 0}, 400 * k.v});
            for (int rule = 0; rule < 7; ++rule) {
                const Points2 cut = k.cut(static_cast<CornerRule>(rule));
                for (const auto& point : cut.rowwise()) {
                    double distance = point.norm();
                    for (int i = 0; i < 3; ++i) {
                        const RowVector2d from = seamLine.row(i), to = seamLine.row((i + 1) % 3);
                        distance = std::min(
                            distance, geometry::distanceToSegment(RowVector2d(point), from, to));
                    }
                    EXPECT_LE(distance, 2.5 * std::max(a, b) + kExact)
                        << degrees << " degrees, rule " << rule << ", widths " << a << ", " << b;
                }
            }
        }
    }
}

TEST(CuttingLine, TakesVeryShortEdgesAndRepeatedPoints) {
    const Points2 plain = asPoints({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    const Points2 expected = cuttingLine(plain, {{0, 10}, {1, 20}, {2, 30}, {3, 40}});
    for (const double step : {0.0, 1e-9, 1e-6, 2e-5}) {
        const Points2 seamLine = asPoints({{0, 0},
                                           {50, 0},
                                           {50 + step, 0},
                                           {100, 0},
                                           {100, step},
                                           {100, 100},
                                           {0, 100},
                                           {0, 100 - step}});
        const Points2 cut = cuttingLine(seamLine, {{0, 10}, {3, 20}, {5, 30}, {6, 40}});
        EXPECT_LE(test::apart(cut, expected), 2 * step + kExact) << step;
    }
}

TEST(CuttingLine, ClosesASlotNarrowerThanItsAllowances) {
    const Points2 seamLine = asPoints(
        {{0, 0}, {100, 0}, {100, 100}, {55, 100}, {60, 20}, {40, 20}, {45, 100}, {0, 100}});
    const Points2 cut = cuttingLine(seamLine, {{0, 7}});
    EXPECT_EQ(test::troubleWith({seamLine, {{0, 7}}}, cut), "");
    EXPECT_LT(test::outside({50, 40}, cut), 0);  // wider than the allowances: a hole
    expectOn(cut, {{0, 107}, {100, 107}});
}

/// Ordinarily kOutlines; tests/nightly.sh asks for more.
int outlineCount() {
    constexpr int kOutlines = 200;
    const char* asked = std::getenv("TOILE_OUTLINES");       // NOLINT(concurrency-mt-unsafe)
    return asked == nullptr ? kOutlines : std::atoi(asked);  // NOLINT(cert-err34-c)
}

/// Every so-manieth outline: several processors share the work.
class ShardOfCuttingLines : public testing::TestWithParam<int> {};

constexpr int kOutlineShards = 8;
INSTANTIATE_TEST_SUITE_P(RandomOutlines, ShardOfCuttingLines, testing::Range(0, kOutlineShards));

TEST_P(ShardOfCuttingLines, AreSimpleAndHoldAllAllowances) {
    for (int seed = GetParam(); seed < outlineCount(); seed += kOutlineShards) {
        const AllowanceCase shape = test::randomAllowances(seed);
        ASSERT_EQ(test::troubleWith(shape, shape.cut()), "") << "seed " << seed;
    }
}

TEST_P(ShardOfCuttingLines, MoveWithThePieceAndMirrorWithIt) {
    for (int seed = GetParam(); seed < outlineCount(); seed += kOutlineShards) {
        const AllowanceCase shape = test::randomAllowances(seed);
        const Points2 cut = shape.cut();
        ASSERT_EQ(cut, shape.cut());
        const RowVector2d by(17.3, -40);
        EXPECT_LE(test::apart(test::moved(shape, 1.1, by).cut(),
                              test::moved({cut, {}}, 1.1, by).seamLine),
                  kExact)
            << "seed " << seed;
        EXPECT_LE(test::apart(test::mirrored(shape).cut(), test::mirrored({cut, {}}).seamLine),
                  kExact)
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace toile
