// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/disk_check.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/core/support/literal_mesh.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::meshOf;

void expectDefect(const MeshArrays& mesh, ErrorCode code) {
    const DiskCheck check = checkDisk(mesh, "sleeve");
    ASSERT_TRUE(check.defect) << "no defect found";
    EXPECT_EQ(name(check.defect->code), name(code));
    EXPECT_EQ(check.defect->subject.name, "sleeve");
    EXPECT_FALSE(check.defect->detail.empty());
    EXPECT_TRUE(check.boundary.empty());
}

TEST(DiskCheck, AGridIsADiskWithItsRimAsBoundary) {
    const DiskCheck check = checkDisk(test::planeGrid(4, 3, 10), "piece");
    EXPECT_FALSE(check.defect);
    EXPECT_EQ(check.boundary.size(), 14U);
    EXPECT_EQ(check.boundary.front(), 0);
    EXPECT_EQ(check.boundary[1], 1);  // anti-clockwise: the surface is on the left
    EXPECT_EQ(check.table.edges.rows(), 4 * 4 + 3 * 5 + 12);
}

TEST(DiskCheck, ASingleTriangleIsADisk) {
    const DiskCheck check =
        checkDisk(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), "piece");
    EXPECT_FALSE(check.defect);
    EXPECT_EQ(check.boundary.size(), 3U);
}

TEST(DiskCheck, EdgesAreSortedAndFacesKnowThem) {
    const MeshArrays mesh = test::renumber(test::sphericalCap(5, 100, 1), 7).mesh;
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    for (int e = 1; e < table.edges.rows(); ++e) {
        EXPECT_TRUE(table.edges(e - 1, 0) < table.edges(e, 0) ||
                    (table.edges(e - 1, 0) == table.edges(e, 0) &&
                     table.edges(e - 1, 1) < table.edges(e, 1)));
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto ends = std::minmax({mesh.F(f, k), mesh.F(f, (k + 1) % 3)});
            EXPECT_EQ(table.edges(table.faceEdges(f, k), 0), ends.first);
            EXPECT_EQ(table.edges(table.faceEdges(f, k), 1), ends.second);
        }
    }
}

TEST(DiskCheck, NamesAClosedSurface) {
    expectDefect(test::octahedron(), ErrorCode::ClosedSurface);
}

TEST(DiskCheck, NamesSeveralLoops) {
    expectDefect(test::tube(12, 3), ErrorCode::SeveralLoops);
    const DiskCheck check = checkDisk(test::tube(12, 3), "leg");
    EXPECT_EQ(check.defect->detail,
              "2 loops: 311 mm at 0.0, 0.0, 50.0 mm; 311 mm at 0.0, 60.0, 50.0 mm");
}

TEST(DiskCheck, NamesAHandle) {
    expectDefect(test::piercedTorus(12, 8), ErrorCode::Handle);
}

TEST(DiskCheck, NamesAOneSidedSurface) {
    expectDefect(test::moebiusStrip(20), ErrorCode::NotOrientable);
}

TEST(DiskCheck, NamesOpposedWinding) {
    MeshArrays mesh = test::planeGrid(4, 4, 10);
    std::swap(mesh.F(5, 0), mesh.F(5, 1));
    expectDefect(mesh, ErrorCode::OpposedWinding);
}

TEST(DiskCheck, NamesAnEdgeOfThreeFaces) {
    expectDefect(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                        {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
                 ErrorCode::NonManifoldEdge);
}

TEST(DiskCheck, NamesAPinchedVertex) {
    expectDefect(
        meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}),
        ErrorCode::NonManifoldVertex);
}

TEST(DiskCheck, NamesADoubledFace) {
    expectDefect(
        meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}, {1, 2, 0}}),
        ErrorCode::DuplicateFace);
}

TEST(DiskCheck, NamesATriangleWithoutArea) {
    MeshArrays mesh = test::planeGrid(2, 2, 10);
    mesh.V.row(4) = 0.5 * (mesh.V.row(0) + mesh.V.row(1));
    expectDefect(mesh, ErrorCode::DegenerateFace);
    expectDefect(meshOf({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}), ErrorCode::DegenerateFace);
}

TEST(DiskCheck, NamesANonFinitePosition) {
    MeshArrays mesh = test::planeGrid(2, 2, 10);
    mesh.V(3, 1) = std::numeric_limits<double>::quiet_NaN();
    expectDefect(mesh, ErrorCode::NotFinite);
}

TEST(DiskCheck, FindsTheSameAtAnyScale) {
    for (const double scale : {1e-7, 1.0, 1e6}) {
        MeshArrays cap = test::sphericalCap(6, scale, 1.2);
        EXPECT_FALSE(checkDisk(cap, "cap").defect) << scale;
        cap.V.rowwise() += Eigen::RowVector3d(1e4 * scale, -1e4 * scale, 1e4 * scale);
        EXPECT_FALSE(checkDisk(cap, "cap").defect) << scale;
    }
}

TEST(Components, AreNumberedByFirstFace) {
    Triangles F(4, 3);
    F << 3, 4, 5, 0, 1, 2, 5, 6, 7, 1, 8, 2;
    EXPECT_EQ(faceComponents(F, 9), (std::vector<int>{0, 1, 0, 1}));
}

}  // namespace
}  // namespace toile
