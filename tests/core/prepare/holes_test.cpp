// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/holes.h"

#include <gtest/gtest.h>

#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using test::edgesOf;

TEST(ScanHoles, AreToldFromOpenings) {
    const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 25);
    const EdgeTable table = edgesOf(mesh);
    EXPECT_EQ(rimsOf(mesh, table).size(), 3U);
    // Waist and hem are openings, of whatever size holes may be.
    const std::vector<RimLoop> holes = findHoles(mesh, table, 1e6);
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_GT(flatness(mesh, table, holes[0]), 0.9);
    EXPECT_LT(holes[0].perimeter, 300);
    EXPECT_TRUE(findHoles(mesh, table, holes[0].perimeter - 1).empty());
}

TEST(ScanHoles, NeitherTheEndOfATubeNorAnOutlineIsOne) {
    const MeshArrays tube = test::tube(12, 4);
    for (const RimLoop& rim : rimsOf(tube, edgesOf(tube))) {
        EXPECT_NEAR(flatness(tube, edgesOf(tube), rim), 0, 1e-9);
    }
    const MeshArrays patch = test::planeGrid(2, 2, 5);
    ASSERT_EQ(rimsOf(patch, edgesOf(patch)).size(), 1U);
    EXPECT_NEAR(flatness(patch, edgesOf(patch), rimsOf(patch, edgesOf(patch))[0]), -1, 1e-9);
    EXPECT_TRUE(findHoles(patch, edgesOf(patch), 1000).empty());
}

TEST(ScanHoles, FlatnessDoesNotDependOnPlaceNorNumbering) {
    MeshArrays mesh = test::withHole(test::skirt(), 40, 200, 30);
    const RimLoop hole = findHoles(mesh, edgesOf(mesh), 1000).at(0);
    const double before = flatness(mesh, edgesOf(mesh), hole);
    mesh.V.rowwise() += Eigen::RowVector3d(1e5, -3e5, 2e5);
    EXPECT_NEAR(flatness(mesh, edgesOf(mesh), hole), before, 1e-6);
    const MeshArrays other = test::renumber(mesh, 7).mesh;
    const std::vector<RimLoop> found = findHoles(other, edgesOf(other), 1000);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(flatness(other, edgesOf(other), found[0]), before, 1e-6);
}

}  // namespace
}  // namespace toile
