// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "tests/core/cut/surface.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::expectValidPath;
using test::Surface;

TEST(Straightened, KeepsALoopAroundAHandle) {
    const Surface s(test::piercedTorus(32, 16));
    std::vector<int> ring;
    for (int i = 0; i <= 32; ++i) {  // around the long way, wavering, on the outside
        ring.push_back(i % 32 * 16 + (i == 0 ? 0 : 1));
        ring.push_back(i % 32 * 16);
    }
    const PathPolyline loop = polylineOf(s.links, ring);
    const PathPolyline tight = straightened(s.links, loop);
    EXPECT_LT(tight.length, loop.length);
    EXPECT_GT(tight.length, 2 * std::numbers::pi * 30 * 0.98);  // not less than the inner equator
    expectValidPath(s, tight);
}

TEST(Polyline, OfVerticesLiesWhereTheyDo) {
    const Surface s(test::piercedTorus(32, 16));
    const std::vector<int> way = {16, 0, 1, 2};
    const auto points = positionsOf(s.mesh, polylineOf(s.links, way));
    ASSERT_EQ(points.size(), way.size());
    for (std::size_t k = 0; k < way.size(); ++k) {
        EXPECT_EQ(points[k], s.mesh.V.row(way[k]).transpose());
    }
}

TEST(NearestSurface, FindsWhatASearchOfAllTrianglesFinds) {
    const MeshArrays mesh = test::saddle(12, 100, 1.5);
    const NearestSurface nearest(mesh);
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p(random() % 200 - 100.0, random() % 200 - 100.0,
                                random() % 200 - 100.0);
        double least = HUGE_VAL;
        for (int f = 0; f < mesh.F.rows(); ++f) {
            const SurfacePoint point{
                f, nearestInTriangle(p, mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)),
                                     mesh.V.row(mesh.F(f, 2)))};
            least = std::min(least, (positionOf(mesh, point) - p).norm());
        }
        const SurfacePoint found = nearest.find(p);
        EXPECT_NEAR((positionOf(mesh, found) - p).norm(), least, 1e-12);
        EXPECT_NEAR(found.barycentric.sum(), 1, 1e-12);
        EXPECT_GE(found.barycentric.minCoeff(), -1e-15);
    }
    const SurfacePoint vertex = nearest.find(mesh.V.row(20).transpose());
    EXPECT_EQ(vertex.barycentric.maxCoeff(), 1);
}

TEST(NearestSurface, FindsATriangleHoweverFarAwayThePointIs) {
    const MeshArrays mesh = test::saddle(12, 100, 1.5);
    const NearestSurface nearest(mesh);
    for (const double far : {1e150, -1e200, 1e300, std::numeric_limits<double>::max()}) {
        const SurfacePoint found = nearest.find({far, 0, -far});
        EXPECT_GE(found.face, 0) << far;
        EXPECT_LT(found.face, mesh.F.rows()) << far;
        EXPECT_NEAR(found.barycentric.sum(), 1, 1e-12) << far;
    }
}

TEST(EdgePath, IsTheShortestWay) {
    const Surface s(test::planeGrid(4, 1, 1));
    EXPECT_NEAR(edgePath(s.links, 0, 4)->length, 4, 1e-15);
}

}  // namespace
}  // namespace toile
