// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/user_cuts.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/core/cut/cut_checks.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Traces all cuts and cuts the mesh along them, in order.
Result<CutResult> applyUserCuts(const MeshArrays& mesh, const std::vector<UserCut>& cuts) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    const NearestSurface nearest(mesh);
    std::vector<PathPolyline> paths;
    for (const UserCut& cut : cuts) {
        auto path = traceUserCut(links, nearest, cut);
        if (!path) {
            return path.error();
        }
        paths.push_back(std::move(*path));
    }
    return cutAlong(mesh, paths);
}

CutResult cut(const MeshArrays& mesh, const std::vector<UserCut>& cuts) {
    auto result = applyUserCuts(mesh, cuts);
    EXPECT_TRUE(result) << (result ? "" : sentence(result.error()));
    test::expectValidCut(mesh, *result, cuts.front().name);
    return std::move(*result);
}

TEST(UserCuts, APathFromRimToRimOpensATube) {
    const MeshArrays tube = test::tube(24, 9);
    UserCut seam{"inseam", UserCut::Kind::Path, {{51, -2, 3}, {49, 90, 4}, {51, 183, 3}}, false};
    const CutResult result = cut(tube, {seam});
    EXPECT_EQ(test::expectDisks(result.mesh, "tube"), 1);
    EXPECT_NEAR(result.cuts[0].length, 180, 0.5);
    seam.alongEdges = true;
    const CutResult edges = cut(tube, {seam});
    EXPECT_EQ(edges.mesh.F.rows(), tube.F.rows());
    EXPECT_NEAR(edges.cuts[0].length, 180, 1e-9);
}

TEST(UserCuts, ALoopCutsATubeInTwo) {
    const MeshArrays tube = test::tube(24, 9);
    const UserCut ring{
        "knee", UserCut::Kind::Loop, {{60, 90, 0}, {-20, 93, 50}, {-20, 88, -50}}, false};
    EXPECT_EQ(test::componentCount(cut(tube, {ring}).mesh), 2);
}

TEST(UserCuts, ADartReachesTheRim) {
    const MeshArrays grid = test::planeGrid(10, 10, 10);
    for (const bool turned : {false, true}) {
        UserCut dart{"waist dart", UserCut::Kind::Dart, {{42, 9, 0}, {47, 55, 0}}, false};
        if (turned) {
            std::swap(dart.points[0], dart.points[1]);
        }
        const CutResult result = cut(grid, {dart});
        const CutRun& run = result.cuts[0].runs[0];
        EXPECT_NE(run.left.front() == run.right.front(), run.left.back() == run.right.back());
        EXPECT_NEAR(run.length, std::hypot(5, 55), 0.05);
        EXPECT_EQ(test::expectDisks(result.mesh, "dart"), 1);
    }
}

TEST(UserCuts, SurviveAChangeOfTheMesh) {
    const UserCut seam{"side", UserCut::Kind::Path, {{30, 0, 0}, {60, 55, 0}, {70, 100, 0}}, false};
    const double coarse = cut(test::planeGrid(5, 5, 20), {seam}).cuts[0].length;
    const double fine =
        cut(test::renumber(test::planeGrid(40, 40, 2.5), 8).mesh, {seam}).cuts[0].length;
    EXPECT_NEAR(coarse, fine, 0.1);
}

TEST(UserCuts, NameTheCutThatCannotBeMade) {
    const MeshArrays grid = test::planeGrid(4, 4, 10);
    const auto why = [&](const UserCut& wrong) {
        const auto result = applyUserCuts(grid, {wrong});
        EXPECT_FALSE(result);
        return result.error().subject.name;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(why({"a", UserCut::Kind::Path, {{1, 1, 0}}, false}), "a");
    EXPECT_EQ(why({"b", UserCut::Kind::Loop, {{1, 1, 0}, {9, 9, 0}}, false}), "b");
    EXPECT_EQ(why({"c", UserCut::Kind::Path, {{1, 1, 0}, {nan, 0, 0}}, false}), "c");
    EXPECT_FALSE(applyUserCuts(test::octahedron(),
                               {{"d", UserCut::Kind::Dart, {{1, 0, 0}, {0, 0, 1}}, false}}));
}

}  // namespace
}  // namespace toile
