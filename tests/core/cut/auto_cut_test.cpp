// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/auto_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/cut/surface_paths.h"
#include "tests/core/cut/auto_cut_checks.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

TEST(AutoCut, LeavesADiskAlone) {
    const AutoCut proposal = test::propose(test::planeGrid(4, 4, 10));
    EXPECT_TRUE(proposal.cuts.empty());
    EXPECT_TRUE(proposal.holesToFill.empty());
}

TEST(AutoCut, ATubeTakesOneSeamOfItsHeight) {
    for (const unsigned seed : {0U, 1U, 2U}) {
        const MeshArrays tube = test::tube(24, 9);
        const AutoCut proposal =
            test::expectOneDisk(seed == 0 ? tube : test::renumber(tube, seed).mesh, "tube");
        ASSERT_EQ(proposal.cuts.size(), 1U);
        EXPECT_NEAR(proposal.cuts[0].length, 180, 1e-9);
    }
}

TEST(AutoCut, ATwistedTubeIsStillCutStraight) {
    // Rows turned by half a step each: no way along edges is straight, and their lengths tie.
    MeshArrays tube = test::tube(24, 10);
    for (int v = 0; v < tube.V.rows(); ++v) {
        const double phi = 2 * std::numbers::pi * (v % 24 - 0.5 * (v / 24)) / 24;
        tube.V.row(v) << 50 * std::sin(phi), 11.0 * (v / 24), 50 * std::cos(phi);
    }
    const AutoCut proposal = test::expectOneDisk(tube, "twisted tube");
    ASSERT_EQ(proposal.cuts.size(), 1U);
    EXPECT_NEAR(proposal.cuts[0].length, 110, 0.5);
}

TEST(AutoCut, JoinsThreeLoopsByTwoSeams) {
    const MeshArrays mesh = test::without(test::planeGrid(20, 12, 10), [](int f) {
        const int column = f / 2 % 20;
        const int row = f / 40;
        return (row == 5 || row == 6) && (column == 4 || column == 5 || column / 3 == 4);
    });
    AutoCutOptions never;
    never.smallHole = 0;
    const AutoCut proposal = test::expectOneDisk(mesh, "two holes", never);
    EXPECT_EQ(proposal.cuts.size(), 2U);
    EXPECT_TRUE(proposal.holesToFill.empty());
    const AutoCut flat = test::expectOneDisk(mesh, "two holes in flat cloth");
    EXPECT_TRUE(flat.cuts.empty());
    EXPECT_EQ(flat.holesToFill.size(), 2U);
}

TEST(AutoCut, FillsASmallHoleInsteadOfCuttingToIt) {
    const MeshArrays mesh =
        test::without(test::planeGrid(30, 30, 10), [](int f) { return f / 2 == 217; });
    const AutoCut small = test::expectOneDisk(mesh, "button hole");
    EXPECT_TRUE(small.cuts.empty());
    ASSERT_EQ(small.holesToFill.size(), 1U);
    EXPECT_NEAR(small.holesToFill[0].perimeter, 40, 1e-12);
    const auto filled = applyAutoCut(mesh, small);
    EXPECT_EQ(filled->mesh.F.rows(), 1800 - 2 + 4);
    EXPECT_EQ(std::ranges::count(filled->sourceFace, -1), 4);
    AutoCutOptions never;
    never.smallHole = 0;
    EXPECT_EQ(test::propose(mesh, never).cuts.size(), 1U);
}

TEST(AutoCut, KeepsSeamsOffTheHolesItFills) {
    // The straight seam of the tube would cross every one of the holes in its way.
    const MeshArrays tube = test::without(
        test::tube(40, 30), [](int f) { return f / 2 % 40 % 3 == 1 && f / 80 == 15; });
    AutoCutOptions options;
    options.smallHole = 0.2;
    const AutoCut proposal = test::propose(tube, options);
    EXPECT_EQ(proposal.holesToFill.size(), 13U);
    ASSERT_EQ(proposal.cuts.size(), 1U);
    EXPECT_LT(proposal.cuts[0].length, 1.1 * 600);
    const auto result = applyAutoCut(tube, proposal);
    EXPECT_EQ(test::expectDisks(result->mesh, "holes"), 1);
    for (const CutRun& run : result->cuts[0].runs) {
        for (std::size_t i = 0; i < run.left.size(); ++i) {
            const int v = result->sourceVertex[run.left[i]];
            for (const RimLoop& hole : proposal.holesToFill) {
                EXPECT_EQ(std::ranges::count(hole.vertices, v), 0);
            }
        }
    }
}

TEST(AutoCut, AShutHoleIsRaisedToACone) {
    // A buttonhole: a slit without area.
    const MeshArrays grid = test::planeGrid(30, 30, 10);
    const EdgeTable table = buildEdgeTable(grid.F, static_cast<int>(grid.V.rows()));
    const SurfaceLinks links(grid, table);
    const auto slit = cutAlong(grid, {polylineOf(links, {200, 201, 202})});
    ASSERT_TRUE(slit);
    const AutoCut proposal = test::expectOneDisk(slit->mesh, "buttonhole");
    EXPECT_TRUE(proposal.cuts.empty());
    EXPECT_EQ(proposal.holesToFill.size(), 1U);
}

TEST(AutoCut, OpensAPiercedTorus) {
    for (const unsigned seed : {0U, 4U}) {
        const MeshArrays torus = test::piercedTorus(32, 16);
        const AutoCut proposal = test::expectOneDisk(
            seed == 0 ? torus : test::renumber(torus, seed).mesh, "pierced torus");
        ASSERT_EQ(proposal.cuts.size(), 2U);
        EXPECT_NEAR(proposal.cuts[0].length, 2 * std::numbers::pi * 20, 15);
    }
}

TEST(AutoCut, OpensAClosedTorus) {
    const MeshArrays torus = test::closedTorus(32, 16);
    const AutoCut proposal = test::expectOneDisk(torus, "torus");
    double total = 0;
    for (const PathPolyline& cut : proposal.cuts) {
        total += cut.length;
    }
    EXPECT_LT(total, 2 * std::numbers::pi * (20 + 30) * 1.3);
}

TEST(AutoCut, OpensClosedSurfaces) {
    test::expectOneDisk(test::octahedron(), "octahedron");
    const AutoCut cut = test::expectOneDisk(test::sphere(16), "sphere");
    ASSERT_EQ(cut.cuts.size(), 1U);
    EXPECT_NEAR(cut.cuts[0].length, std::numbers::pi * 50, 2);
    MeshArrays tetrahedron{Points3(4, 3), Triangles(4, 3)};
    tetrahedron.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    tetrahedron.F << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
    test::expectOneDisk(tetrahedron, "tetrahedron");
}

TEST(AutoCut, OpensACubeAlongItsEdges) {
    const AutoCut proposal = test::expectOneDisk(test::closedBox(6, 60), "cube");
    double total = 0;
    for (const PathPolyline& cut : proposal.cuts) {
        total += cut.length;
    }
    EXPECT_NEAR(total, 7 * 60, 1e-9);  // a tree over eight corners has seven edges
}

TEST(AutoCut, OpensHandlesOneByOne) {
    std::set<test::Cell> ladder;  // two holes
    std::set<test::Cell> frame;   // the edges of a cube: five
    for (int c = 0; c < 13 * 7 * 7; ++c) {
        const test::Cell cell{c % 13, c / 13 % 7, c / 91};
        const auto [x, y, z] = cell;
        const bool isHole = y >= 2 && y < 5 && ((x >= 2 && x < 5) || (x >= 8 && x < 11));
        if (z < 2 && !isHole) {
            ladder.insert(cell);
        }
        if (x < 7 && (x % 6 == 0) + (y % 6 == 0) + (z % 6 == 0) >= 2) {
            frame.insert(cell);
        }
    }
    for (const auto& body : {ladder, frame}) {
        const MeshArrays mesh = test::voxelSurface(body, 10);
        for (const unsigned seed : {0U, 1U, 2U}) {
            test::expectOneDisk(seed == 0 ? mesh : test::renumber(mesh, seed).mesh, "handles");
        }
    }
}

TEST(AutoCut, SaysWhatItDoesNotTake) {
    AutoCutOptions one;
    one.maxLoops = 1;
    one.smallHole = 0;
    const MeshArrays tube = test::tube(8, 3);
    const EdgeTable table = buildEdgeTable(tube.F, static_cast<int>(tube.V.rows()));
    EXPECT_EQ(proposeCuts(tube, table, one).error().code, ErrorCode::SeveralLoops);
    const MeshArrays strip = test::moebiusStrip(12);
    EXPECT_EQ(proposeCuts(strip, buildEdgeTable(strip.F, 24)).error().code,
              ErrorCode::NotOrientable);
}

}  // namespace
}  // namespace toile
