// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/prepare/holes.h"
#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using test::edgesOf;

TEST(HolePatches, PatchesContinueTheSurface) {
    const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 45);
    const std::vector<RimLoop> holes = findHoles(mesh, edgesOf(mesh), 1000);
    const PatchedSurface patched = withPatches(mesh, holes, Progress());
    ASSERT_GT(patched.hole.size(), 10U);
    EXPECT_EQ(patched.mesh.F.rows(),
              mesh.F.rows() + static_cast<Eigen::Index>(patched.hole.size()));
    EXPECT_EQ(patched.mesh.F.topRows(mesh.F.rows()), mesh.F);
    EXPECT_EQ(patched.mesh.V.topRows(mesh.V.rows()), mesh.V);
    EXPECT_TRUE(isValidSurface(patched.mesh, edgesOf(patched.mesh)));
    EXPECT_EQ(test::perimeters(patched.mesh).size(), 2U);
    // A flat patch of 45 mm radius would lie 7 mm within the cylinder.
    EXPECT_LT(test::offSkirt(patched.mesh.V).most, 2);
    EXPECT_NEAR(test::clothArea(patched.mesh), test::clothArea(test::skirt()),
                1e-3 * test::clothArea(mesh));
    const MeshArrays again = withPatches(mesh, holes, Progress()).mesh;
    EXPECT_EQ(again.V, patched.mesh.V);
    EXPECT_EQ(again.F, patched.mesh.F);
}

TEST(HolePatches, AHoleWhosePatchWouldDoubleATriangleStaysOpen) {
    const MeshArrays mesh = test::planeGrid(1, 1, 10);
    const std::vector<RimLoop> outline = rimsOf(mesh, edgesOf(mesh));
    const PatchedSurface patched = withPatches(mesh, outline, Progress());
    EXPECT_LE(patched.hole.size(), 2U);  // of four corners, the other diagonal is free
    const MeshArrays one = test::part(mesh, [](const auto& middle) { return middle.x() > 5; });
    ASSERT_EQ(one.F.rows(), 1);
    const PatchedSurface none = withPatches(one, rimsOf(one, edgesOf(one)), Progress());
    EXPECT_TRUE(none.mesh.V.allFinite());
}

TEST(HolePatches, AFlatHoleGetsAFlatPatch) {
    const MeshArrays whole = test::planeGrid(40, 40, 5);
    const Eigen::RowVector3d middle = whole.V.colwise().mean();
    const MeshArrays mesh = test::part(whole, [&middle](const Eigen::RowVector3d& at) {
        return (at - middle).cwiseAbs().maxCoeff() > 40;
    });
    const std::vector<RimLoop> holes = findHoles(mesh, edgesOf(mesh), 1000);
    ASSERT_EQ(holes.size(), 1U);  // with straight sides
    const PatchedSurface patched = withPatches(mesh, holes, Progress());
    EXPECT_TRUE(isValidSurface(patched.mesh, edgesOf(patched.mesh)));
    EXPECT_NEAR(test::clothArea(patched.mesh), 200 * 200, 1e-6);
}

TEST(HolePatches, APatchBelongsToItsHole) {
    const MeshArrays mesh = test::withHole(test::withHole(test::skirt(), 0, 300, 30), 60, 120, 15);
    const std::vector<RimLoop> holes = findHoles(mesh, edgesOf(mesh), 1000);
    ASSERT_EQ(holes.size(), 2U);
    const PatchedSurface patched = withPatches(mesh, holes, Progress());
    EXPECT_TRUE(isValidSurface(patched.mesh, edgesOf(patched.mesh)));
    for (std::size_t i = 0; i < patched.hole.size(); ++i) {
        const auto face = mesh.F.rows() + static_cast<Eigen::Index>(i);
        const double height = patched.mesh.V(patched.mesh.F(face, 0), 1);
        const double rim = mesh.V(holes[static_cast<std::size_t>(patched.hole[i])].vertices[0], 1);
        EXPECT_LT(std::abs(height - rim), 70);
    }
}

TEST(HolePatches, HolesOfManyEdgesStayOpen) {
    const MeshArrays mesh = test::tube(401, 1);
    const PatchedSurface patched = withPatches(mesh, rimsOf(mesh, edgesOf(mesh)), Progress());
    EXPECT_TRUE(patched.hole.empty());
    EXPECT_EQ(patched.mesh.F, mesh.F);
}

TEST(HolePatches, ACancelIsHeard) {
    Progress progress;
    progress.cancel();
    const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 45);
    EXPECT_TRUE(withPatches(mesh, findHoles(mesh, edgesOf(mesh), 1000), progress).hole.empty());
}

}  // namespace
}  // namespace toile
