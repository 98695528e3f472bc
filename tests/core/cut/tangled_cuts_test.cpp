// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that cross each other hundreds of times, or cannot be cut along at all.
#include <random>

#include <gtest/gtest.h>

#include "core/cut/auto_cut.h"
#include "core/cut/surface_paths.h"
#include "core/cut/user_cuts.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/surface.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::Surface;

PathPolyline randomLine(const Surface& s, std::mt19937& random) {
    const SurfacePoint from = test::randomPoint(s.mesh, random);
    return *geodesicPath(s.links, from, test::randomPoint(s.mesh, random));
}

/// A path of so many legs to and fro, whose parts nobody could sew.
PathPolyline tangle(const Surface& s, int legs) {
    std::mt19937 random(3);
    PathPolyline whole;
    SurfacePoint at = test::randomPoint(s.mesh, random);
    for (int i = 0; i < legs; ++i) {
        const SurfacePoint next = test::randomPoint(s.mesh, random);
        const auto leg = geodesicPath(s.links, at, next);
        whole.points.insert(whole.points.end(), leg->points.begin() + (i == 0 ? 0 : 1),
                            leg->points.end());
        at = next;
    }
    return whole;
}

/// From the first row of a grid to the last, straight along its edges.
PathPolyline column(const Surface& s, int columns, int rows, int at) {
    std::vector<int> vertices;
    for (int row = 0; row <= rows; ++row) {
        vertices.push_back(row * (columns + 1) + at);
    }
    return polylineOf(s.links, vertices);
}

TEST(TangledCuts, AHundredLinesThroughAFewTrianglesAreCut) {
    const Surface s(test::planeGrid(3, 3, 60));
    std::mt19937 random(5);
    std::vector<PathPolyline> paths;
    for (int i = 0; i < 100; ++i) {
        paths.push_back(randomLine(s, random));
    }
    const std::vector<PathPolyline> some(paths.begin(), paths.begin() + 30);
    const auto first = cutAlong(s.mesh, some);
    ASSERT_TRUE(first) << sentence(first.error());
    test::expectValidCut(s.mesh, *first, "lines");
    const auto result = cutAlong(s.mesh, paths);
    ASSERT_TRUE(result) << sentence(result.error());
    EXPECT_NEAR(test::totalArea(result->mesh), 180 * 180, 1e-6);
    EXPECT_GT(test::componentCount(result->mesh), 500);
}

TEST(TangledCuts, PathsThatEndInOnePointMeetThere) {
    const Surface s(test::planeGrid(3, 3, 60));
    std::mt19937 random(11);
    for (int i = 0; i < 200; ++i) {
        // From two corners to one point, after others have split the triangles around it.
        const SurfacePoint meet = test::randomPoint(s.mesh, random);
        std::vector<PathPolyline> paths;
        for (const int corner : {0, 15}) {
            paths.push_back(*geodesicPath(s.links, s.links.atVertex(corner), meet));
            for (int k = 0; k < 5; ++k) {
                paths.push_back(*geodesicPath(s.links, meet, test::randomPoint(s.mesh, random)));
            }
        }
        const auto result = cutAlong(s.mesh, paths);
        ASSERT_TRUE(result) << sentence(result.error());
        EXPECT_GE(test::componentCount(result->mesh), 2) << i;
    }
}

TEST(TangledCuts, ATangleIsRefusedWithItsReason) {
    const Surface s(test::planeGrid(3, 3, 60));
    const auto result = cutAlong(s.mesh, {tangle(s, 3000)});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::CutImpossible);
    EXPECT_NE(result.error().detail.find("crosses itself"), std::string::npos);
}

TEST(TangledCuts, WhatIsLeftOutLeavesNoTrace) {
    const Surface s(test::planeGrid(4, 4, 10));
    const PathPolyline nowhere{{s.links.atVertex(0), s.links.atVertex(24)}, 0};
    std::mt19937 random(8);
    for (const PathPolyline& bad : {nowhere, tangle(s, 3000)}) {
        const std::vector<PathPolyline> good{randomLine(s, random), randomLine(s, random),
                                             randomLine(s, random)};
        const auto expected = cutAlong(s.mesh, good);
        const auto made =
            cutAlong(s.mesh, {good[0], bad, good[1], bad, good[2]}, {.leavesOut = true});
        ASSERT_TRUE(made) << sentence(made.error());
        EXPECT_EQ(made->mesh.V, expected->mesh.V);
        EXPECT_EQ(made->mesh.F, expected->mesh.F);
        ASSERT_EQ(made->cuts.size(), 5U);
        for (std::size_t c = 0; c < 5; ++c) {
            EXPECT_EQ(made->cuts[c].error.has_value(), c % 2 == 1);
            EXPECT_EQ(made->cuts[c].length, c % 2 == 1 ? 0 : expected->cuts[c / 2].length);
        }
        EXPECT_FALSE(cutAlong(s.mesh, {good[0], bad, good[1]}));
    }
}

TEST(TangledCuts, EverySlitOfOneEdgeOpens) {
    const Surface s(test::planeGrid(60, 60, 10));
    std::vector<PathPolyline> slits;
    for (int row = 2; row < 60; row += 2) {
        for (int at = 1; at < 58; at += 3) {
            const int v = row * 61 + at;
            slits.push_back(polylineOf(s.links, {v, v + 1}));
        }
    }
    const auto result = cutAlong(s.mesh, slits);
    ASSERT_TRUE(result);
    test::expectValidCut(s.mesh, *result, "slits");
    for (const OpenedCut& slit : result->cuts) {
        ASSERT_EQ(slit.runs.size(), 1U);
        EXPECT_EQ(slit.runs[0].left.size(), 3U);
        EXPECT_NE(slit.runs[0].left[1], slit.runs[0].right[1]);
    }
}

TEST(TangledCuts, EveryStepCanBeCancelled) {
    const Surface s(test::planeGrid(6, 6, 10));
    Progress cancelled;
    cancelled.cancel();
    const auto codeOf = [](const auto& result) {
        return result ? ErrorCode::CutImpossible : result.error().code;
    };
    EXPECT_EQ(codeOf(cutAlong(s.mesh, {column(s, 6, 6, 3)}, {}, cancelled)), ErrorCode::Cancelled);
    EXPECT_EQ(codeOf(cutAlong(s.mesh, {column(s, 6, 6, 3)}, {.leavesOut = true}, cancelled)),
              ErrorCode::Cancelled);
    EXPECT_EQ(codeOf(edgePath(s.links, 0, 48, cancelled)), ErrorCode::Cancelled);
    for (const bool alongEdges : {false, true}) {
        EXPECT_EQ(codeOf(pathOfCut(s.links, s.links.atVertex(0), s.links.atVertex(48), alongEdges,
                                   cancelled)),
                  ErrorCode::Cancelled);
    }
    const Surface tube(test::tube(12, 4));
    EXPECT_EQ(codeOf(proposeCuts(tube.mesh, tube.table, {}, cancelled)), ErrorCode::Cancelled);
}

TEST(WayOfCut, AlongEdgesRunsBetweenTheNearestVertices) {
    const Surface s(test::planeGrid(6, 6, 10));
    const SurfacePoint from{0, {0.8, 0.1, 0.1}};
    const auto way = pathOfCut(s.links, from, s.links.atVertex(6), true);
    ASSERT_TRUE(way);
    EXPECT_EQ(way->points.size(), 7U);
    EXPECT_NEAR(way->length, 60, 1e-12);
    test::expectValidPath(s, *way);
}

}  // namespace
}  // namespace toile
