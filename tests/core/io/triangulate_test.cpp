// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polygon = std::vector<Vector2d>;

void addFace(PolygonSoup& soup, const std::vector<Vector3d>& corners) {
    for (const Vector3d& corner : corners) {
        soup.corners.push_back(static_cast<int>(soup.positions.size()));
        soup.positions.push_back(corner);
    }
    soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
}

/// Ways of laying the plane of a polygon into space: turned, tiny, huge, far away.
std::vector<Eigen::Affine3d> placements() {
    std::vector<Eigen::Affine3d> all;
    for (const double scale : {1.0, 1e-7, 1e6}) {
        for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 2, 3), Vector3d(-1, 0, 0.1)}) {
            for (const double angle : {0.0, 1.0, 3.0}) {
                all.push_back(Eigen::Scaling(scale) *
                              Eigen::Affine3d(Eigen::AngleAxisd(angle, axis.normalized())));
            }
        }
    }
    all.push_back(Eigen::Affine3d(Eigen::Translation3d(1e6, -1e6, 1e6)));
    return all;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

/// Smallest signed height over longest edge of the triangles, seen in the polygon's plane.
double worstShape(const Triangulation& triangles, const Polygon& polygon) {
    double worst = 1;
    for (const auto& row : triangles.F.rowwise()) {
        const Vector2d &a = polygon[row[0]], &b = polygon[row[1]], &c = polygon[row[2]];
        const double longest2 =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        worst = std::min(worst, area({a, b, c}) * 2 / longest2);
    }
    return worst;
}

double totalArea(const Triangulation& triangles, const Polygon& polygon) {
    double sum = 0;
    for (const auto& row : triangles.F.rowwise()) {
        sum += std::abs(area({polygon[row[0]], polygon[row[1]], polygon[row[2]]}));
    }
    return sum;
}

Triangulation triangulated(const Polygon& polygon,
                           const Eigen::Affine3d& placement = Eigen::Affine3d::Identity()) {
    PolygonSoup soup;
    std::vector<Vector3d> corners;
    for (const Vector2d& p : polygon) {
        corners.push_back(placement * Vector3d(p.x(), p.y(), 0));
    }
    addFace(soup, corners);
    return triangulate(soup, "test");
}

/// n - 2 triangles that all keep the polygon's orientation, are not flat, and fill its area.
void expectFills(const Triangulation& triangles, const Polygon& polygon) {
    EXPECT_TRUE(triangles.problems.empty());
    ASSERT_EQ(triangles.F.rows(), static_cast<Eigen::Index>(polygon.size()) - 2);
    EXPECT_GT(worstShape(triangles, polygon), kDegenerateHeight);
    EXPECT_NEAR(totalArea(triangles, polygon), area(polygon), 1e-9 * area(polygon));
}

/// However the polygon lies in space and whichever corner comes first.
void expectDivided(Polygon polygon) {
    for (const Eigen::Affine3d& placement : placements()) {
        expectFills(triangulated(polygon, placement), polygon);
    }
    for (std::size_t first = 0; first < std::min<std::size_t>(polygon.size(), 12); ++first) {
        SCOPED_TRACE(first);
        expectFills(triangulated(polygon), polygon);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
}

TEST(Triangulate, PassesTrianglesUnchanged) {
    PolygonSoup soup;
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    addFace(soup, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    soup.corners[3] = 0;
    const Triangulation triangles = triangulate(soup, "test");
    EXPECT_EQ(triangles.F, (Triangles(2, 3) << 0, 1, 2, 0, 4, 5).finished());
    EXPECT_EQ(triangles.sourceFace, (std::vector<int>{0, 1}));
    EXPECT_TRUE(triangles.problems.empty());
}

TEST(Triangulate, DividesAQuadAtItsShorterDiagonal) {
    expectDivided({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_EQ(triangulated({{0, 0}, {3, -1}, {6, 0}, {3, 1}}).F,
              (Triangles(2, 3) << 0, 1, 3, 1, 2, 3).finished());
    EXPECT_EQ(triangulated({{3, -1}, {6, 0}, {3, 1}, {0, 0}}).F,
              (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished());
    EXPECT_EQ(triangulated({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).F,
              (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished())
        << "equal diagonals: always the same one";
}

TEST(Triangulate, DividesAConcaveQuadInside) {
    expectDivided({{0, 0}, {2, 1}, {0, 2}, {0.5, 1}});
    expectDivided({{0, 0}, {10, 0}, {0.1, 0.1}, {0, 10}});
}

TEST(Triangulate, KeepsFlatCornersFromMakingFlatTriangles) {
    expectDivided({{0, 0}, {1, 0}, {2, 0}, {1, 5}});
    expectDivided({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}});
    expectDivided({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 1}});
    expectDivided(
        {{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}, {1, 0}, {1, 0.3}, {1, 1}, {0.7, 1}, {0, 1}});
}

TEST(Triangulate, KeepsTheShapeOfConcavePolygons) {
    expectDivided({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}});
    expectDivided({{0, 0},
                   {7, 0},
                   {7, 5},
                   {6, 5},
                   {6, 1},
                   {4, 1},
                   {4, 5},
                   {3, 5},
                   {3, 1},
                   {1, 1},
                   {1, 5},
                   {0, 5}});
    expectDivided({{0, 0},
                   {9, 0},
                   {9, 9},
                   {1, 9},
                   {1, 3},
                   {6, 3},
                   {6, 6},
                   {4, 6},
                   {4, 5},
                   {5, 5},
                   {5, 4},
                   {2, 4},
                   {2, 8},
                   {8, 8},
                   {8, 1},
                   {0, 1}});
}

TEST(Triangulate, DividesStarsAndRounds) {
    std::mt19937 random(42);
    std::uniform_real_distribution<double> radius(0.05, 1);
    for (const int n : {5, 6, 7, 12, 50, 200}) {
        Polygon round, star;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            round.emplace_back(std::cos(angle), std::sin(angle));
            star.push_back(round.back() * radius(random));
        }
        expectDivided(round);
        expectDivided(star);
    }
}

TEST(Triangulate, DividesStepsWithManyFlatCorners) {
    std::mt19937 random(3);
    for (const int steps : {2, 5, 9, 30}) {
        Polygon polygon;
        for (int i = 0; i <= steps; ++i) {
            polygon.emplace_back(i, 0);
        }
        for (int i = steps - 1; i >= 0; --i) {
            const double height = 1 + random() % 4;
            polygon.emplace_back(i + 1, height);
            polygon.emplace_back(i + 0.5, height);
            polygon.emplace_back(i, height);
        }
        polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
        expectDivided(polygon);
    }
}

TEST(Triangulate, DividesAPolygonJoinedToItsHole) {
    expectDivided({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST(Triangulate, DividesAPolygonWithABridgedHole) {
    // The corners at both ends of the bridge occur twice, as modelling programs write it.
    const Polygon places{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}};
    const std::vector<int> rim{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    for (std::size_t first = 0; first < rim.size(); ++first) {
        PolygonSoup soup;
        for (const Vector2d& place : places) {
            soup.positions.emplace_back(place.x(), place.y(), 0);
        }
        for (std::size_t k = 0; k < rim.size(); ++k) {
            soup.corners.push_back(rim[(first + k) % rim.size()]);
        }
        soup.faceStart.push_back(static_cast<int>(rim.size()));
        const Triangulation triangles = triangulate(soup, "test");
        EXPECT_TRUE(triangles.problems.empty());
        ASSERT_EQ(triangles.F.rows(), 8);
        EXPECT_NEAR(totalArea(triangles, places), 12, 1e-12);
        EXPECT_GT(worstShape(triangles, places), kDegenerateHeight);
    }
}

TEST(Triangulate, LeavesOutAFaceThatTouchesItselfOtherwise) {
    // Two squares that share a corner; a square with a spike.
    const Polygon places{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 2}, {4, 4}, {2, 4}, {-2, 0}};
    for (const std::vector<int>& rim :
         {std::vector<int>{0, 1, 2, 4, 5, 6, 2, 3}, std::vector<int>{0, 7, 0, 1, 2, 3}}) {
        PolygonSoup soup;
        for (const Vector2d& place : places) {
            soup.positions.emplace_back(place.x(), place.y(), 0);
        }
        soup.corners = rim;
        soup.faceStart.push_back(static_cast<int>(rim.size()));
        const Triangulation triangles = triangulate(soup, "test");
        EXPECT_EQ(triangles.F.rows(), 0);
        EXPECT_EQ(detailOf(triangles.problems, ErrorCode::DegenerateFaceRecord),
                  "1 face left out: a corner is repeated, face 1");
    }
}

TEST(Triangulate, DividesABentPolygon) {
    PolygonSoup soup;
    std::vector<Vector3d> corners;
    for (int i = 0; i < 9; ++i) {
        const double angle = 2 * std::numbers::pi * i / 9;
        corners.emplace_back(std::cos(angle), std::sin(angle), 0.3 * std::cos(2 * angle));
    }
    addFace(soup, corners);
    const Triangulation triangles = triangulate(soup, "test");
    EXPECT_TRUE(triangles.problems.empty());
    EXPECT_EQ(triangles.F.rows(), 7);
    std::set<std::pair<int, int>> directed;
    for (const auto& row : triangles.F.rowwise()) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(directed.emplace(row[k], row[(k + 1) % 3]).second);
        }
    }
    for (int i = 0; i < 9; ++i) {
        EXPECT_TRUE(directed.count({i, (i + 1) % 9})) << "the outline stays";
    }
}

TEST(Triangulate, FansAndListsWhatCrossesItself) {
    const Polygon pentagram{
        {0, 1}, {-0.588, -0.809}, {0.951, 0.309}, {-0.951, 0.309}, {0.588, -0.809}};
    const Polygon eight{{0, 0}, {2, 2}, {4, 0}, {4, 2}, {2, 0}, {0, 2}};
    const Polygon bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, unevenBow{{0, 0}, {1, 1}, {1, 0}, {0, 2}};
    const Polygon line{{0, 0}, {1, 0}, {2, 0}, {3, 0}},
        longLine{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}};
    for (const Polygon& polygon : {pentagram, eight, bow, unevenBow, line, longLine}) {
        const Triangulation triangles = triangulated(polygon);
        ASSERT_EQ(triangles.F.rows(), static_cast<Eigen::Index>(polygon.size()) - 2);
        for (Eigen::Index i = 0; i < triangles.F.rows(); ++i) {
            EXPECT_EQ(triangles.F.row(i),
                      Eigen::RowVector3i(0, static_cast<int>(i) + 1, static_cast<int>(i) + 2));
        }
        EXPECT_EQ(detailOf(triangles.problems, ErrorCode::PolygonNotSimple),
                  "1 face split as a fan: it crosses itself or has no area, face 1");
    }
}

TEST(Triangulate, FansWhatHasTooManyCorners) {
    Polygon round;
    for (int i = 0; i < 5000; ++i) {
        round.emplace_back(std::cos(i * 2 * std::numbers::pi / 5000),
                           std::sin(i * 2 * std::numbers::pi / 5000));
    }
    const Triangulation triangles = triangulated(round);
    EXPECT_EQ(triangles.F.rows(), 4998);
    EXPECT_EQ(triangles.problems.size(), 1u);
}

TEST(Triangulate, LeavesOutAndListsUnusableFaces) {
    PolygonSoup soup;
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0.5, 0}});
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    addFace(soup, {{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}});
    soup.corners[1] = soup.corners[0];
    soup.corners[5] = soup.corners[3];
    soup.corners[11] = soup.corners[7];
    const Triangulation triangles = triangulate(soup, "test");
    EXPECT_EQ(triangles.sourceFace, (std::vector<int>{3, 3}));
    ASSERT_EQ(triangles.problems.size(), 2u);
    EXPECT_EQ(triangles.problems[0].code, ErrorCode::DegenerateFaceRecord);
    EXPECT_EQ(triangles.problems[0].detail,
              "3 faces left out: a corner is repeated, first at face 1");
    EXPECT_EQ(triangles.problems[1].code, ErrorCode::NonFinitePosition);
    EXPECT_EQ(triangles.problems[1].detail, "1 face left out, face 5");
}

TEST(Triangulate, CopesWithExtremeNumbers) {
    for (const double size : {1e308, 1e200, 1e-200, 1e-300, 5e-324}) {
        PolygonSoup soup;
        addFace(soup, {{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0}});
        addFace(
            soup,
            {{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {0, size, 0}, {-size, size, 0}});
        EXPECT_EQ(triangulate(soup, "test").F.rows(), 5) << size;
    }
}

TEST(Triangulate, TakesAnEmptySoup) {
    EXPECT_EQ(triangulate(PolygonSoup(), "test").F.rows(), 0);
}

}  // namespace
}  // namespace toile::test
