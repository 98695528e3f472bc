// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/remesh.h"

#include <gtest/gtest.h>

#include "tests/core/prepare/scan_shapes.h"

namespace toile {
namespace {

using test::edgesOf;

void expectEqual(const MeshArrays& a, const MeshArrays& b) {
    EXPECT_EQ(a.V, b.V);
    EXPECT_EQ(a.F, b.F);
}

TEST(Remesh, PatchesContinueTheSurface) {
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
    expectEqual(withPatches(mesh, holes, Progress()).mesh, patched.mesh);
}

TEST(Remesh, AHoleWhosePatchWouldDoubleATriangleStaysOpen) {
    const MeshArrays mesh = test::planeGrid(1, 1, 10);
    const std::vector<RimLoop> outline = rimsOf(mesh, edgesOf(mesh));
    const PatchedSurface patched = withPatches(mesh, outline, Progress());
    EXPECT_LE(patched.hole.size(), 2U);  // of four corners, the other diagonal is free
    const MeshArrays one = test::part(mesh, [](const auto& middle) { return middle.x() > 5; });
    ASSERT_EQ(one.F.rows(), 1);
    const PatchedSurface none = withPatches(one, rimsOf(one, edgesOf(one)), Progress());
    EXPECT_TRUE(none.mesh.V.allFinite());
}

TEST(Remesh, TrianglesAreEvenAndRimsAndAreaStay) {
    for (const double length : {6.0, 25.0}) {
        const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 45);
        const auto fresh = remeshed(mesh, length, Progress());
        ASSERT_TRUE(fresh);
        EXPECT_TRUE(isValidSurface(*fresh, edgesOf(*fresh)));
        EXPECT_NEAR(test::clothArea(*fresh), test::clothArea(mesh), 0.01 * test::clothArea(mesh));
        const std::vector<double> before = test::perimeters(mesh), after = test::perimeters(*fresh);
        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_NEAR(after[i], before[i], 0.01 * before[i]);
        }
        const Edges edges = edgesOf(*fresh).edges;
        int even = 0;
        for (int e = 0; e < edges.rows(); ++e) {
            const double ratio =
                (fresh->V.row(edges(e, 0)) - fresh->V.row(edges(e, 1))).norm() / length;
            even += ratio > 0.5 && ratio < 1.6 ? 1 : 0;
        }
        EXPECT_GT(even, 0.95 * static_cast<double>(edges.rows()));
        expectEqual(*remeshed(mesh, length, Progress()), *fresh);
    }
}

TEST(Remesh, CornersOfAnOutlineStay) {
    const MeshArrays mesh = test::planeGrid(40, 40, 5);
    const auto fresh = remeshed(mesh, 12, Progress());
    ASSERT_TRUE(fresh);
    EXPECT_NEAR(test::clothArea(*fresh), 200 * 200, 1e-6);
    EXPECT_NEAR(test::perimeters(*fresh).at(0), 800, 1e-6);
}

TEST(Remesh, WhatWouldTakeForEverIsNotBegun) {
    EXPECT_FALSE(remeshed(test::skirt(), 0.05, Progress()));
    constexpr int kRim = 500;  // a disk, all of whose triangles meet in its middle
    MeshArrays fan{Points3(kRim + 1, 3), Triangles(kRim, 3)};
    fan.V.row(kRim).setZero();
    for (int v = 0; v < kRim; ++v) {
        const double angle = 2 * std::numbers::pi * v / kRim;
        fan.V.row(v) << std::cos(angle), std::sin(angle), 0;
        fan.F.row(v) << v, (v + 1) % kRim, kRim;
    }
    EXPECT_FALSE(remeshed(fan, 0.1, Progress()));
}

TEST(Remesh, ACancelIsHeard) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(remeshed(test::skirt(), 10, progress));
    const MeshArrays mesh = test::withHole(test::skirt(), 0, 300, 45);
    EXPECT_TRUE(withPatches(mesh, findHoles(mesh, edgesOf(mesh), 1000), progress).hole.empty());
}

}  // namespace
}  // namespace toile
