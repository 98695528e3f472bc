// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_along.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Geodesics through points of the plane z = 0, or the nearest on the mesh.
PathPolyline through(const MeshArrays& mesh, const std::vector<Eigen::Vector3d>& points) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const NearestSurface nearest(mesh);
    PathPolyline whole;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto leg =
            geodesicPath(links, nearest.find(points[i - 1]), nearest.find(points[i])).value();
        whole.points.insert(whole.points.end(), leg.points.begin() + (i == 1 ? 0 : 1),
                            leg.points.end());
        whole.length += leg.length;
    }
    return whole;
}

CutResult cut(const MeshArrays& mesh, const std::vector<PathPolyline>& paths,
              const std::string& what) {
    auto result = cutAlong(mesh, paths);
    EXPECT_TRUE(result) << what;
    test::expectValidCut(mesh, *result, what);
    return std::move(*result);
}

TEST(CutAlong, ASlitOpensBetweenItsTwoEnds) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    const CutResult result = cut(grid, {through(grid, {{22, 33, 0}, {71, 58, 0}})}, "slit");
    ASSERT_EQ(result.cuts[0].runs.size(), 1U);
    const CutRun& run = result.cuts[0].runs[0];
    EXPECT_EQ(run.left.front(), run.right.front());
    EXPECT_EQ(run.left.back(), run.right.back());
    for (std::size_t i = 1; i + 1 < run.left.size(); ++i) {
        EXPECT_NE(run.left[i], run.right[i]);
    }
    EXPECT_NEAR(run.length, std::hypot(49, 25), 0.05);
    EXPECT_EQ(test::componentCount(result.mesh), 1);
}

TEST(CutAlong, LeftIsToTheLeftOfThePath) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const CutResult result = cut(grid, {through(grid, {{20, 0, 0}, {20, 40, 0}})}, "halves");
    EXPECT_EQ(test::componentCount(result.mesh), 2);
    EXPECT_EQ(test::expectDisks(result.mesh, "halves"), 2);
    const CutRun& run = result.cuts[0].runs[0];
    for (int f = 0; f < result.mesh.F.rows(); ++f) {
        double x = 0;
        for (int k = 0; k < 3; ++k) {
            x += result.mesh.V(result.mesh.F(f, k), 0) / 3;
        }
        for (int k = 0; k < 3; ++k) {
            const int v = result.mesh.F(f, k);
            if (std::ranges::find(run.left, v) != run.left.end()) {
                EXPECT_LT(x, 20);
            }
            if (std::ranges::find(run.right, v) != run.right.end()) {
                EXPECT_GT(x, 20);
            }
        }
    }
}

TEST(CutAlong, ADartOpensAtTheRim) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    const CutResult result = cut(grid, {through(grid, {{37, 0, 0}, {45, 61, 0}})}, "dart");
    const CutRun& run = result.cuts[0].runs[0];
    EXPECT_NE(run.left.front(), run.right.front());
    EXPECT_EQ(run.left.back(), run.right.back());
    EXPECT_EQ(test::expectDisks(result.mesh, "dart"), 1);
}

TEST(CutAlong, ALoopSeparates) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    const auto loop = through(grid, {{22, 33, 0}, {71, 28, 0}, {55, 81, 0}, {22, 33, 0}});
    const CutResult result = cut(grid, {loop}, "loop");
    EXPECT_EQ(test::componentCount(result.mesh), 2);
}

TEST(CutAlong, ALoopInsideOneTriangleSeparates) {
    const MeshArrays grid = test::planeGrid(1, 1, 100);
    const auto loop = through(grid, {{70, 20, 0}, {90, 20, 0}, {90, 40, 0}, {70, 20, 0}});
    const CutResult result = cut(grid, {loop}, "triangle");
    EXPECT_EQ(test::componentCount(result.mesh), 2);
    EXPECT_NEAR(result.cuts[0].length, 40 + std::hypot(20, 20), 1e-9);
}

TEST(CutAlong, CrossingPathsMeetInAVertex) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    const CutResult result =
        cut(grid,
            {through(grid, {{13, 0, 0}, {88, 100, 0}}), through(grid, {{0, 71, 0}, {100, 17, 0}})},
            "cross");
    EXPECT_EQ(test::componentCount(result.mesh), 4);
    EXPECT_EQ(test::expectDisks(result.mesh, "cross"), 4);
    EXPECT_EQ(result.cuts[0].runs.size(), 2U);
    EXPECT_EQ(result.cuts[1].runs.size(), 2U);
}

TEST(CutAlong, SharedStretchesBelongToTheFirstPath) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    const CutResult result = cut(grid,
                                 {through(grid, {{0, 50, 0}, {70, 50, 0}}),
                                  through(grid, {{0, 50, 0}, {40, 50, 0}, {40, 100, 0}})},
                                 "shared");
    EXPECT_NEAR(result.cuts[0].length, 70, 1e-9);
    EXPECT_NEAR(result.cuts[1].length, 50, 1e-9);
    EXPECT_EQ(test::expectDisks(result.mesh, "shared"), 2);
}

TEST(CutAlong, NothingOpensAlongTheRim) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const CutResult result = cut(grid, {through(grid, {{0, 0, 0}, {40, 0, 0}})}, "rim");
    EXPECT_TRUE(result.cuts[0].runs.empty());
    EXPECT_EQ(result.mesh.F, grid.F);
}

TEST(CutAlong, ASlitOfOneEdgeGetsAVertexInItsMiddle) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const CutResult result = cut(grid, {through(grid, {{10, 10, 0}, {20, 10, 0}})}, "edge");
    EXPECT_EQ(result.cuts[0].runs[0].left.size(), 3U);
    EXPECT_EQ(result.mesh.V.rows(), grid.V.rows() + 2);
}

TEST(CutAlong, PointsNearAVertexMoveOntoIt) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const CutResult result = cut(grid, {through(grid, {{10.03, 0.02, 0}, {10.04, 40, 0}})}, "near");
    EXPECT_EQ(result.mesh.F.rows(), grid.F.rows());
    EXPECT_EQ(test::componentCount(result.mesh), 2);
}

TEST(CutAlong, KeepsAreaAndSidesOnRandomPaths) {
    int done = 0;
    for (const MeshArrays& mesh : {test::planeGrid(9, 7, 10), test::sphericalCap(7, 100, 1.3),
                                   test::saddle(8, 100, 1.5), test::piercedTorus(16, 9)}) {
        const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
        const SurfaceLinks links(mesh, table);
        std::mt19937 random(11);
        for (int i = 0; i < 50; ++i) {
            const auto path = test::randomPath(links, random);
            cut(mesh, {*path}, "random " + std::to_string(done++));
        }
    }
    EXPECT_EQ(done, 200);
}

TEST(CutAlong, MakesNoNeedles) {
    const MeshArrays grid = test::planeGrid(9, 7, 10);
    const EdgeTable table = buildEdgeTable(grid.F, static_cast<int>(grid.V.rows()));
    const SurfaceLinks links(grid, table);
    std::mt19937 random(12);
    for (int i = 0; i < 100; ++i) {
        const auto path = test::randomPath(links, random);
        const auto result = cutAlong(grid, {*path});
        ASSERT_TRUE(result);
        EXPECT_GT(test::leastAngle(result->mesh), 0.4 * std::numbers::pi / 180);
    }
}

TEST(CutAlong, StandsManyCrossingPaths) {
    for (const MeshArrays& mesh :
         {test::planeGrid(2, 2, 50), test::sphericalCap(4, 100, 1.3), test::piercedTorus(12, 7)}) {
        const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
        const SurfaceLinks links(mesh, table);
        for (unsigned seed = 0; seed < 10; ++seed) {
            std::mt19937 random(seed);
            std::vector<PathPolyline> paths;
            for (int i = 0; i < 12; ++i) {
                paths.push_back(*test::randomPath(links, random));
            }
            cut(mesh, paths, "crossing " + std::to_string(seed));
        }
    }
}

TEST(CutAlong, RefusesWhatItCannotCut) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const EdgeTable table = buildEdgeTable(grid.F, static_cast<int>(grid.V.rows()));
    const SurfaceLinks links(grid, table);
    EXPECT_FALSE(cutAlong(grid, {{{links.atVertex(0), links.atVertex(24)}, 0}}));
    MeshArrays fin = grid;
    fin.F.conservativeResize(fin.F.rows() + 1, 3);
    fin.F.row(fin.F.rows() - 1) << 6, 7, 20;
    EXPECT_EQ(cutAlong(fin, {}).error().code, ErrorCode::NonManifoldEdge);
    MeshArrays turned = grid;
    std::swap(turned.F(5, 0), turned.F(5, 1));
    EXPECT_EQ(cutAlong(turned, {}).error().code, ErrorCode::OpposedWinding);
}

}  // namespace
}  // namespace toile
