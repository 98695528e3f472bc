// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/cut/surface.h"
#include "tests/core/support/growth.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::expectValidPath;
using test::Surface;

TEST(Geodesic, IsTheStraightLineOnAPlane) {
    for (const bool renumbered : {false, true}) {
        const MeshArrays grid = test::planeGrid(17, 23, 10);
        const Surface s(renumbered ? test::renumber(grid, 3).mesh : grid);
        std::mt19937 random(1);
        for (int i = 0; i < 100; ++i) {
            const SurfacePoint a = test::randomPoint(s.mesh, random);
            const SurfacePoint b = test::randomPoint(s.mesh, random);
            const auto path = geodesicPath(s.links, a, b);
            ASSERT_TRUE(path);
            const double distance = (positionOf(s.mesh, a) - positionOf(s.mesh, b)).norm();
            EXPECT_NEAR(path->length, distance, 1e-12 * (1 + distance));
            expectValidPath(s, *path);
        }
    }
}

TEST(Geodesic, GivesControlBackWhenCancelled) {
    const Surface s(test::planeGrid(100, 100, 1));
    Progress progress;
    const SurfacePoint from = s.links.atVertex(0), to = s.links.atVertex(101 * 101 - 1);
    EXPECT_TRUE(geodesicPath(s.links, from, to, progress));
    progress.cancel();
    const auto path =
        geodesicPath(s.links, s.links.atVertex(100), s.links.atVertex(101 * 100), progress);
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, ErrorCode::Cancelled);
}

TEST(Geodesic, RunsThroughVerticesOfAPlaneWithoutBending) {
    const Surface s(test::planeGrid(8, 8, 1));
    const auto diagonal = geodesicPath(s.links, s.links.atVertex(8), s.links.atVertex(72));
    ASSERT_TRUE(diagonal);
    EXPECT_NEAR(diagonal->length, 8 * std::sqrt(2.0), 1e-12);
    const auto side = geodesicPath(s.links, s.links.atVertex(0), s.links.atVertex(8));
    ASSERT_TRUE(side);
    EXPECT_NEAR(side->length, 8, 1e-12);
    expectValidPath(s, *side);
}

/// Distance on a sector mesh whose rulings are straight, from its flat unrolled rows.
TEST(Geodesic, IsTheUnrolledStraightLineOnACylinder) {
    const int columns = 24;
    const double angle = 2.5;
    const Surface s(test::cylinderSector(columns, 16, 40, angle, 90));
    const double chord = 2 * 40 * std::sin(angle / columns / 2);
    // Column, and height in its ruling, say where a vertex is when unrolled.
    const auto unrolled = [&](const SurfacePoint& p) {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (int k = 0; k < 3; ++k) {
            const int v = s.mesh.F(p.face, k);
            sum += p.barycentric[k] * Eigen::Vector2d(chord * (v % (columns + 1)), s.mesh.V(v, 1));
        }
        return sum;
    };
    std::mt19937 random(2);
    for (int i = 0; i < 60; ++i) {
        const SurfacePoint a = test::randomPoint(s.mesh, random);
        const SurfacePoint b = test::randomPoint(s.mesh, random);
        const Eigen::Vector2d p = unrolled(a);
        const Eigen::Vector2d q = unrolled(b);
        // The upper rim slopes upwards without a dent, so the straight line stays inside.
        const auto path = geodesicPath(s.links, a, b);
        ASSERT_TRUE(path);
        EXPECT_NEAR(path->length, (p - q).norm(), 1e-9);
        expectValidPath(s, *path);
    }
}

TEST(Geodesic, IsTheUnrolledStraightLineOnACone) {
    const int columns = 20;
    const double inner = 30;
    const double outer = 130;
    const double slope = 0.5;
    const Surface s(test::coneSector(columns, 12, inner, outer, 2.0, slope));
    // Unrolled, each column is an isosceles triangle at the apex.
    const double chord = 2 * std::sin(slope) * std::sin(2.0 / columns / 2);
    const double step = 2 * std::asin(chord / 2);
    const auto unrolled = [&](const SurfacePoint& p) {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (int k = 0; k < 3; ++k) {
            const int v = s.mesh.F(p.face, k);
            const double phi = step * (v % (columns + 1));
            sum += p.barycentric[k] * s.mesh.V.row(v).norm() *
                   Eigen::Vector2d(std::cos(phi), std::sin(phi));
        }
        return sum;
    };
    std::mt19937 random(3);
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        const SurfacePoint a = test::randomPoint(s.mesh, random);
        const SurfacePoint b = test::randomPoint(s.mesh, random);
        const Eigen::Vector2d p = unrolled(a);
        const Eigen::Vector2d q = unrolled(b);
        const double t = std::clamp(-p.dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
        const auto path = geodesicPath(s.links, a, b);
        ASSERT_TRUE(path);
        EXPECT_GE(path->length, (p - q).norm() - 1e-9);
        if ((p + t * (q - p)).norm() > inner) {  // does not leave the sector by its inner rim
            EXPECT_NEAR(path->length, (p - q).norm(), 1e-9);
            ++compared;
        }
    }
    EXPECT_GT(compared, 30);
}

TEST(Geodesic, GoesAroundTheCornerOfABox) {
    const Surface s(test::openBox(6, 60));
    const auto at = [&](double x, double y, double z) {
        return NearestSurface(s.mesh).find({x, y, z});
    };
    // From one side wall over the lid to the neighbouring wall, or straight across their edge.
    const auto across = geodesicPath(s.links, at(60, 47, 33), at(48, 60, 35));
    ASSERT_TRUE(across);
    EXPECT_NEAR(across->length, std::hypot(13 + 12, 2), 1e-9);
    const auto overLid = geodesicPath(s.links, at(60, 13, 55), at(47, 0, 57));
    ASSERT_TRUE(overLid);
    EXPECT_NEAR(overLid->length, std::hypot(18, 16), 1e-9);
    const auto opposite = geodesicPath(s.links, at(0, 31, 50), at(60, 28, 50));
    ASSERT_TRUE(opposite);
    EXPECT_NEAR(opposite->length, std::hypot(80, 3), 1e-9);
}

TEST(Geodesic, BendsAtADentInTheRim) {
    // An L: the way from arm to arm turns at the inner corner, and may run along the rim.
    MeshArrays mesh = test::planeGrid(10, 10, 1);
    Triangles F(0, 3);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3d middle =
            (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
        if (middle.x() < 4 || middle.y() < 4) {
            F.conservativeResize(F.rows() + 1, 3);
            F.row(F.rows() - 1) = mesh.F.row(f);
        }
    }
    mesh.F = F;
    const Surface s(mesh);
    const auto path =
        geodesicPath(s.links, s.links.atVertex(11 * 10 + 4), s.links.atVertex(4 * 11 + 10));
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->length, 12, 1e-12);  // along the rim all the way
    const auto shorter = geodesicPath(s.links, s.links.atVertex(11 * 10), s.links.atVertex(10));
    ASSERT_TRUE(shorter);
    EXPECT_NEAR(shorter->length, 2 * std::hypot(4, 6), 1e-12);
    expectValidPath(s, *shorter);
}

TEST(Geodesic, IsNeverLongerThanTheWayAlongEdges) {
    int improved = 0;
    for (const MeshArrays& mesh :
         {test::sphericalCap(12, 100, 1.4), test::saddle(14, 100, 1.5), test::piercedTorus(24, 12),
          test::cubeOpenedAlongH(), test::octahedron()}) {
        const Surface s(mesh);
        std::mt19937 random(4);
        for (int i = 0; i < 40; ++i) {
            const int a = static_cast<int>(random() % static_cast<unsigned>(s.mesh.V.rows()));
            const int b = static_cast<int>(random() % static_cast<unsigned>(s.mesh.V.rows()));
            const auto edges = edgePath(s.links, a, b);
            const auto path = geodesicPath(s.links, s.links.atVertex(a), s.links.atVertex(b));
            ASSERT_TRUE(edges);
            ASSERT_TRUE(path);
            EXPECT_LE(path->length, edges->length * (1 + 1e-12));
            const PathPolyline tight = straightened(s.links, *edges);
            EXPECT_LE(tight.length, edges->length * (1 + 1e-12));
            EXPECT_LE(path->length, tight.length * (1 + 1e-3));  // which side of a bump to pass
            expectValidPath(s, *path);
            expectValidPath(s, tight);
            improved += path->length < 0.999 * edges->length ? 1 : 0;
        }
    }
    EXPECT_GT(improved, 100);
}

TEST(Geodesic, DoesNotDependOnNumbering) {
    const Surface s(test::sphericalCap(12, 100, 1.2));
    const test::Renumbered other = test::renumber(s.mesh, 5);
    const Surface t(other.mesh);
    std::mt19937 random(6);
    for (int i = 0; i < 40; ++i) {
        const int a = static_cast<int>(random() % static_cast<unsigned>(s.mesh.V.rows()));
        const int b = static_cast<int>(random() % static_cast<unsigned>(s.mesh.V.rows()));
        const auto p = geodesicPath(s.links, s.links.atVertex(a), s.links.atVertex(b));
        const auto q = geodesicPath(t.links, t.links.atVertex(other.newIndex[a]),
                                    t.links.atVertex(other.newIndex[b]));
        EXPECT_NEAR(p->length, q->length, 1e-9);
    }
}

TEST(Geodesic, SaysWhereThereIsNoWay) {
    MeshArrays two = test::planeGrid(2, 2, 1);
    const int count = static_cast<int>(two.V.rows());
    two.V.conservativeResize(2 * count, 3);
    two.V.bottomRows(count) = two.V.topRows(count).eval().rowwise() + Eigen::RowVector3d(9, 0, 0);
    const int faces = static_cast<int>(two.F.rows());
    two.F.conservativeResize(2 * faces, 3);
    two.F.bottomRows(faces) = two.F.topRows(faces).eval().array() + count;
    const Surface s(two);
    EXPECT_FALSE(geodesicPath(s.links, s.links.atVertex(0), s.links.atVertex(count)));
    EXPECT_FALSE(edgePath(s.links, 0, count));
}

TEST(Geodesic, FromAPointToItselfIsNothing) {
    const Surface s(test::planeGrid(2, 2, 1));
    const auto path = geodesicPath(s.links, s.links.atVertex(4), s.links.atVertex(4));
    ASSERT_TRUE(path);
    EXPECT_EQ(path->length, 0);
}

/// From the first vertex to the last.
Result<PathPolyline> acrossSurface(const Surface& s) {
    return geodesicPath(s.links, s.links.atVertex(0), s.links.atVertex(s.links.vertexCount() - 1));
}

TEST(Geodesic, CrossesALargeMesh) {
    const auto coarse = acrossSurface(Surface(test::saddle(14, 1000, 1.2)));
    const auto fine = acrossSurface(Surface(test::saddle(112, 1000, 1.2)));
    ASSERT_TRUE(coarse && fine);
    EXPECT_NEAR(fine->length, coarse->length, 0.01 * coarse->length);
}

TEST(GeodesicClock, IsQuickOnALargeMesh) {
    const Surface some(test::saddle(112, 1000, 1.2)), more(test::saddle(224, 1000, 1.2));
    EXPECT_LT(test::growth([&] { EXPECT_TRUE(acrossSurface(some)); },
                           [&] { EXPECT_TRUE(acrossSurface(more)); }),
              8);
}

}  // namespace
}  // namespace toile
