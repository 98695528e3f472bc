// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/weld.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/core/mesh/repair_support.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Every triangle with three vertices of its own.
MeshArrays loosened(const MeshArrays& mesh) {
    MeshArrays loose{Points3(mesh.F.size(), 3), Triangles(mesh.F.rows(), 3)};
    for (int corner = 0; corner < mesh.F.size(); ++corner) {
        loose.V.row(corner) = mesh.V.row(mesh.F.data()[corner]);
        loose.F.data()[corner] = corner;
    }
    return loose;
}

TEST(Weld, JoinsLooseTrianglesAgain) {
    for (const MeshArrays& mesh :
         {test::planeGrid(6, 5, 10), test::sphericalCap(5, 100, 1), test::octahedron()}) {
        const MeshArrays loose = loosened(mesh);
        const Weld weld = findWeld(loose.F, loose.V, {});
        EXPECT_EQ(weld.merged, loose.V.rows() - mesh.V.rows());
        const MeshPart part = test::applyWeld(test::asPart(loose), weld);
        EXPECT_EQ(part.mesh.V.rows(), mesh.V.rows());
        EXPECT_EQ(checkDisk(part.mesh, "").defect.has_value(),
                  checkDisk(mesh, "").defect.has_value());
        EXPECT_DOUBLE_EQ(test::areaOf(part.mesh), test::areaOf(mesh));
        EXPECT_TRUE(repair(part, "").repairs.empty());
        for (int v = 0; v < part.mesh.V.rows(); ++v) {
            EXPECT_EQ(weld.target[part.sourceVertex[v]], part.sourceVertex[v]);
        }
    }
}

TEST(Weld, TheLeastIndexWinsAndNoChainForms) {
    // In steps of 0.8 along a line: each within 1 of the next only.
    MeshArrays mesh = loosened(test::planeGrid(2, 1, 1));
    for (int v = 0; v < 12; ++v) {
        mesh.V.row(v) << (v < 4 ? 0.8 * v : 100 * v), 0, 0;
    }
    const Weld weld = findWeld(mesh.F, mesh.V, {.tolerance = 1});
    EXPECT_EQ(weld.target[0], 0);
    EXPECT_EQ(weld.target[1], 0);
    EXPECT_EQ(weld.target[2], 2);
    EXPECT_EQ(weld.target[3], 2);
    EXPECT_EQ(weld.merged, 2);
}

TEST(Weld, TheToleranceIsInclusiveAndCrossesCells) {
    MeshArrays mesh = loosened(test::planeGrid(3, 3, 10));
    const int before = findWeld(mesh.F, mesh.V, {}).merged;
    for (int v = 0; v < mesh.V.rows(); ++v) {  // noise of a hundredth, in all directions
        mesh.V.row(v) += 0.005 * Eigen::RowVector3d(v % 3 - 1, v / 3 % 3 - 1, v / 9 % 3 - 1);
    }
    EXPECT_LT(findWeld(mesh.F, mesh.V, {}).merged, before);
    EXPECT_EQ(findWeld(mesh.F, mesh.V, {.tolerance = 0.02}).merged, before);
    for (const double scale : {1e-7, 1e6}) {
        MeshArrays scaled = mesh;
        scaled.V *= scale;
        EXPECT_EQ(findWeld(scaled.F, scaled.V, {.tolerance = 0.02 * scale}).merged, before);
    }
    mesh.V.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
    EXPECT_EQ(findWeld(mesh.F, mesh.V, {.tolerance = 0.02}).merged, before);
}

TEST(Weld, ATinyToleranceFarApartStaysCountable) {
    MeshArrays mesh = loosened(test::planeGrid(2, 2, 1e6));
    EXPECT_EQ(findWeld(mesh.F, mesh.V, {.tolerance = 1e-300}).merged,
              findWeld(mesh.F, mesh.V, {}).merged);
}

TEST(Weld, LeavesInnerUnusedAndBrokenVerticesAlone) {
    // Two grids on each other: their rims meet, and so would their inner vertices.
    const MeshArrays grid = test::planeGrid(3, 3, 10);
    MeshArrays two{Points3(34, 3), Triangles(36, 3)};
    two.V << grid.V, grid.V, grid.V.topRows(2);  // the last two belong to no face
    two.F << grid.F, grid.F.array() + 16;
    two.V(0, 0) = std::numeric_limits<double>::quiet_NaN();
    two.V(16, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(findWeld(two.F, two.V, {}).merged, 11);  // 12 on the rim, one broken
    EXPECT_EQ(findWeld(two.F, two.V, {.borderOnly = false}).merged, 15);
}

TEST(Weld, MinusZeroIsZero) {
    MeshArrays mesh = loosened(test::planeGrid(1, 1, 10));
    mesh.V.array() *= -1;
    mesh.V.topRows(3).array() += 0.0;
    EXPECT_EQ(findWeld(mesh.F, mesh.V, {}).merged, 2);
}

TEST(Weld, TheNoteNamesCountAndPlace) {
    const MeshArrays mesh = loosened(test::planeGrid(1, 1, 10));
    const Error note = weldNote(findWeld(mesh.F, mesh.V, {}), mesh.V, "front");
    EXPECT_EQ(note.code, ErrorCode::VerticesWelded);
    EXPECT_EQ(note.detail, "2 vertices welded to another, the first at 0.0, 0.0, 0.0 mm");
    EXPECT_TRUE(isNote(note.code));
}

TEST(Weld, TheToleranceFollowsTheMedianEdge) {
    const MeshArrays mesh = test::planeGrid(8, 8, 10);
    EXPECT_NEAR(weldTolerance(mesh.F, mesh.V), 0.01, 1e-12);
    EXPECT_EQ(weldTolerance(Triangles(0, 3), mesh.V), 0);
}

TEST(Weld, KnowsLooseTrianglesFromPieces) {
    const auto looks = [](const MeshArrays& mesh) { return looksUnwelded(mesh.F, mesh.V); };
    EXPECT_TRUE(looks(loosened(test::planeGrid(4, 4, 10))));
    EXPECT_TRUE(looks(loosened(test::octahedron())));
    EXPECT_FALSE(looks(test::planeGrid(4, 4, 10)));
    EXPECT_FALSE(looks(test::planeGrid(1, 1, 10)));
    EXPECT_FALSE(looks(test::cubeSlitAlongOneEdge()));
    MeshArrays apart = loosened(test::planeGrid(4, 4, 10));  // loose, but nothing coincides
    for (int v = 0; v < apart.V.rows(); ++v) {
        apart.V(v, 2) = v;
    }
    EXPECT_FALSE(looks(apart));
}

}  // namespace
}  // namespace toile
