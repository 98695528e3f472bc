// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/support/random_piece.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

EdgeTable tableOf(const MeshArrays& mesh) {
    return buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
}

/// As OpenMesh builds it, face by face.
TriMesh builtFaceByFace(const MeshArrays& mesh) {
    TriMesh halfedges;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        halfedges.new_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        halfedges.add_face(TriMesh::VertexHandle(mesh.F(f, 0)), TriMesh::VertexHandle(mesh.F(f, 1)),
                           TriMesh::VertexHandle(mesh.F(f, 2)));
    }
    return halfedges;
}

std::pair<int, int> ends(const TriMesh& mesh, TriMesh::HalfedgeHandle h) {
    return {mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()};
}

void expectSameSurface(const TriMesh& ours, const TriMesh& theirs) {
    ASSERT_EQ(ours.n_vertices(), theirs.n_vertices());
    ASSERT_EQ(ours.n_edges(), theirs.n_edges());
    ASSERT_EQ(ours.n_faces(), theirs.n_faces());
    for (const auto v : ours.vertices()) {
        EXPECT_EQ(ours.point(v), theirs.point(v));
        EXPECT_EQ(ours.is_boundary(v), theirs.is_boundary(v));
        EXPECT_EQ(ours.valence(v), theirs.valence(v));
        ASSERT_EQ(ours.from_vertex_handle(ours.halfedge_handle(v)), v);
        if (ours.is_boundary(v)) {
            EXPECT_TRUE(ours.is_boundary(ours.halfedge_handle(v)));
        }
    }
    for (const auto h : theirs.halfedges()) {
        const auto own =
            ours.find_halfedge(theirs.from_vertex_handle(h), theirs.to_vertex_handle(h));
        ASSERT_TRUE(own.is_valid());
        EXPECT_EQ(ours.face_handle(own), theirs.face_handle(h));
        EXPECT_EQ(ends(ours, ours.next_halfedge_handle(own)),
                  ends(theirs, theirs.next_halfedge_handle(h)));
        EXPECT_EQ(ends(ours, ours.prev_halfedge_handle(own)),
                  ends(theirs, theirs.prev_halfedge_handle(h)));
    }
    for (const auto f : ours.faces()) {
        EXPECT_EQ(ends(ours, ours.halfedge_handle(f)), ends(theirs, theirs.halfedge_handle(f)));
    }
}

TEST(TriMesh, IsWhatOpenMeshBuildsFaceByFace) {
    std::vector<MeshArrays> meshes{test::planeGrid(1, 1, 10), test::tube(12, 3), test::octahedron(),
                                   test::piercedTorus(9, 7), test::cubeSlitAlongOneEdge()};
    for (unsigned seed = 0; seed < 20; ++seed) {
        meshes.push_back(test::renumber(test::randomPiece(seed), seed).mesh);
    }
    for (const MeshArrays& mesh : meshes) {
        expectSameSurface(*buildTriMesh(mesh, tableOf(mesh)), builtFaceByFace(mesh));
    }
}

TEST(TriMesh, KeepsTheOrderOfCornersAndTheNumbersOfEdges) {
    const MeshArrays mesh = test::renumber(test::saddle(6, 100, 0.5), 3).mesh;
    const EdgeTable table = tableOf(mesh);
    const auto halfedges = buildTriMesh(mesh, table);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        int k = 0;
        for (const auto v : halfedges->fv_range(TriMesh::FaceHandle(f))) {
            EXPECT_EQ(v.idx(), mesh.F(f, k++));
        }
    }
    for (int e = 0; e < table.edges.rows(); ++e) {
        const std::pair<int, int> along(table.edges(e, 0), table.edges(e, 1));
        EXPECT_EQ(ends(*halfedges, TriMesh::HalfedgeHandle(2 * e)), along);
    }
}

/// Some of a mesh's triangles, some of them turned over: fans that meet at a vertex only, and walls
/// between triangles of unlike winding. With `crowded`, edges of three triangles besides.
MeshArrays broken(const MeshArrays& mesh, unsigned seed, bool crowded) {
    std::mt19937 random(seed);
    std::vector<Eigen::RowVector3i> faces;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (random() % 3 == 0) {
            continue;
        }
        faces.emplace_back(mesh.F.row(f));
        if (random() % 8 == 0) {
            std::swap(faces.back()[0], faces.back()[1]);
        }
        if (crowded && random() % 4 == 0) {
            const int apex = static_cast<int>(random() % static_cast<unsigned>(mesh.V.rows()));
            if (apex != mesh.F(f, 0) && apex != mesh.F(f, 1)) {
                faces.emplace_back(mesh.F(f, 1), mesh.F(f, 0), apex);
            }
        }
    }
    MeshArrays made{mesh.V, Triangles(faces.size(), 3)};
    for (std::size_t f = 0; f < faces.size(); ++f) {
        made.F.row(static_cast<Eigen::Index>(f)) = faces[f];
    }
    return made;
}

TEST(TriMesh, HoldsAnyTrianglesWithWallsBetweenThem) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const MeshArrays mesh = broken(test::randomPiece(seed), seed, seed % 2 == 0);
        const EdgeTable table = tableOf(mesh);
        const auto halfedges = buildTriMesh(mesh, table);
        int sides = 0;
        for (const auto h : halfedges->halfedges()) {
            ASSERT_EQ(h.next().prev(), h);
            ASSERT_EQ(h.next().from(), h.to());
            ASSERT_EQ(h.next().face(), h.face());
            sides += h.is_boundary() ? 0 : 1;
        }
        EXPECT_EQ(sides, mesh.F.size());
        for (int side = 0; side < mesh.F.size(); ++side) {
            const auto uses = table.usesOf(table.faceEdges.data()[side]);
            const bool isWall =
                uses.size() != 2 || tailOf(mesh.F, uses[0]) == tailOf(mesh.F, uses[1]);
            const auto face = OpenMesh::make_smart(TriMesh::FaceHandle(side / 3), *halfedges);
            auto h = face.halfedge().next();
            for (int k = 0; k < side % 3; ++k) {
                h = h.next();
            }
            EXPECT_EQ(h.from().idx(), tailOf(mesh.F, side));
            EXPECT_EQ(h.edge().is_boundary(), isWall);
        }
    }
}

TEST(TriMesh, LinksTheBorderOfEachFanWithinIt) {
    // Two triangles that meet at vertex 0 alone.
    MeshArrays mesh{Points3::Random(5, 3), Triangles(2, 3)};
    mesh.F << 0, 1, 2, 0, 3, 4;
    const std::vector<RimLoop> rims = rimsOf(mesh, tableOf(mesh));
    ASSERT_EQ(rims.size(), 2U);
    EXPECT_EQ(rims[0].vertices, std::vector({0, 1, 2}));
    EXPECT_EQ(rims[1].vertices, std::vector({0, 3, 4}));
}

TEST(Rims, GoOnceAlongEverySideAtAWall) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const MeshArrays mesh = broken(test::randomPiece(seed), seed, seed % 2 == 0);
        const EdgeTable table = tableOf(mesh);
        std::vector<std::pair<int, int>> atWalls, along;
        double length = 0;
        for (int side = 0; side < mesh.F.size(); ++side) {
            const auto uses = table.usesOf(table.faceEdges.data()[side]);
            if (uses.size() != 2 || tailOf(mesh.F, uses[0]) == tailOf(mesh.F, uses[1])) {
                atWalls.emplace_back(tailOf(mesh.F, side), headOf(mesh.F, side));
                length +=
                    (mesh.V.row(atWalls.back().first) - mesh.V.row(atWalls.back().second)).norm();
            }
        }
        for (const RimLoop& rim : rimsOf(mesh, table)) {
            for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
                along.emplace_back(rim.vertices[i], rim.vertices[(i + 1) % rim.vertices.size()]);
            }
            length -= rim.perimeter;
        }
        std::ranges::sort(atWalls);
        std::ranges::sort(along);
        EXPECT_EQ(along, atWalls);
        EXPECT_NEAR(length, 0, 1e-6);
    }
}

TEST(Rims, BeginAtTheirLeastVertexInOrder) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const MeshArrays mesh = test::renumber(test::piercedTorus(9, 7), seed).mesh;
        int before = -1;
        for (const RimLoop& rim : rimsOf(mesh, tableOf(mesh))) {
            EXPECT_EQ(rim.vertices.front(), std::ranges::min(rim.vertices));
            EXPECT_LT(std::exchange(before, rim.vertices.front()), rim.vertices.front());
        }
        EXPECT_GE(before, 0);
    }
}

}  // namespace
}  // namespace toile
