// SPDX-License-Identifier: GPL-3.0-or-later

#include <limits>

#include <gtest/gtest.h>

#include "core/mesh/disk_check.h"
#include "core/mesh/repair.h"
#include "tests/core/support/literal_mesh.h"
#include "tests/core/support/random_piece.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::meshOf;

bool isValid(const MeshArrays& mesh) {
    return isValidSurface(mesh, buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows())));
}

/// Both meshes as one, with the second's vertex `glued` made the first's vertex 0.
MeshArrays joinedAt(const MeshArrays& a, const MeshArrays& b, int glued) {
    MeshArrays both;
    both.V.resize(a.V.rows() + b.V.rows() - 1, 3);
    both.V.topRows(a.V.rows()) = a.V;
    both.F.resize(a.F.rows() + b.F.rows(), 3);
    both.F.topRows(a.F.rows()) = a.F;
    const auto renamed = [&](int v) {
        return v == glued ? 0 : static_cast<int>(a.V.rows()) + v - (v > glued ? 1 : 0);
    };
    const Eigen::RowVector3d shift = a.V.row(0) - b.V.row(glued);
    for (int v = 0; v < b.V.rows(); ++v) {
        both.V.row(renamed(v)) = b.V.row(v) + shift;
    }
    for (int f = 0; f < b.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            both.F(a.F.rows() + f, k) = renamed(b.F(f, k));
        }
    }
    return both;
}

TEST(ValidSurface, HoldsForDisksTubesAndClosedSurfacesAtAnyScale) {
    for (const double scale : {1e-6, 1.0, 1e9}) {
        for (MeshArrays mesh :
             {test::planeGrid(4, 3, 10), test::sphericalCap(5, 100, 1), test::tube(12, 3),
              test::octahedron(), test::piercedTorus(9, 7), test::cubeOpenedAlongH()}) {
            mesh.V *= scale;
            EXPECT_TRUE(isValid(mesh));
        }
    }
    for (unsigned seed = 0; seed < 50; ++seed) {
        EXPECT_TRUE(isValid(test::randomPiece(seed))) << seed;
    }
}

TEST(ValidSurface, ComesBackFromRepairAsItWasWithItsEdges) {
    const MeshArrays mesh = test::randomPiece(3);
    MeshPart part{mesh, std::vector<int>(static_cast<std::size_t>(mesh.V.rows()), 1),
                  std::vector<int>(static_cast<std::size_t>(mesh.F.rows()), 2)};
    const RepairResult result = repair(part, "piece");
    EXPECT_TRUE(result.repairs.empty());
    EXPECT_EQ(result.part.mesh.V, mesh.V);
    EXPECT_EQ(result.part.mesh.F, mesh.F);
    EXPECT_EQ(result.part.sourceVertex, part.sourceVertex);
    EXPECT_EQ(result.part.sourceFace, part.sourceFace);
    ASSERT_TRUE(result.validTable);
    const DiskCheck check = checkDisk(mesh, "piece");
    EXPECT_EQ(result.validTable->edges, check.table.edges);
    EXPECT_EQ(checkDisk(mesh, "piece", *result.validTable).boundary, check.boundary);
}

TEST(ValidSurface, DoubtsPositions) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e200}) {
        for (int v = 0; v < 6; ++v) {
            MeshArrays mesh = test::planeGrid(2, 1, 10);
            mesh.V(v, v % 3) = bad;
            EXPECT_FALSE(isValid(mesh)) << bad << " at " << v;
        }
    }
}

TEST(ValidSurface, DoubtsUnusedVertices) {
    MeshArrays mesh = test::planeGrid(2, 2, 10);
    mesh.V.conservativeResize(mesh.V.rows() + 1, 3);
    mesh.V.bottomRows(1).setZero();
    EXPECT_FALSE(isValid(mesh));
}

TEST(ValidSurface, DoubtsTrianglesWithoutHeightOrSide) {
    for (const double height : {0.0, 1e-12, 1e-10}) {
        const MeshArrays flat =
            meshOf({{0, 0, 0}, {2, 0, 0}, {1, height, 0}, {1, 2, 0}}, {{0, 1, 2}, {0, 2, 3}});
        const MeshArrays needle =
            meshOf({{0, 0, 0}, {1, 0, 0}, {1, height, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
        EXPECT_FALSE(isValid(flat)) << height;
        EXPECT_FALSE(isValid(needle)) << height;
    }
    EXPECT_FALSE(isValid(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 1}, {0, 1, 2}})));
}

TEST(ValidSurface, DoubtsEdges) {
    const auto points = {Eigen::RowVector3d(0, 0, 0), Eigen::RowVector3d(1, 0, 0),
                         Eigen::RowVector3d(0, 1, 0), Eigen::RowVector3d(0, -1, 0),
                         Eigen::RowVector3d(0, 0, 1)};
    EXPECT_FALSE(isValid(meshOf(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})));  // three faces
    MeshArrays opposed = meshOf(points, {{0, 1, 2}, {0, 1, 3}});
    opposed.V.conservativeResize(4, 3);
    EXPECT_FALSE(isValid(opposed));
    MeshArrays doubled = meshOf(points, {{0, 1, 2}, {0, 2, 1}});  // a pillow
    doubled.V.conservativeResize(3, 3);
    EXPECT_FALSE(isValid(doubled));
    EXPECT_FALSE(isValid(test::moebiusStrip(7)));
}

TEST(ValidSurface, DoubtsPinchedVertices) {
    const MeshArrays disk = test::planeGrid(2, 2, 10);  // vertex 0 at a corner, 4 inside
    const MeshArrays closed = test::octahedron();
    EXPECT_FALSE(isValid(joinedAt(disk, disk, 0)));    // two open fans
    EXPECT_FALSE(isValid(joinedAt(disk, closed, 0)));  // an open and a closed one
    EXPECT_FALSE(isValid(joinedAt(closed, disk, 4)));  // two closed ones
    EXPECT_FALSE(isValid(joinedAt(closed, closed, 3)));
}

}  // namespace
}  // namespace toile
