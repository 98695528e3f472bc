// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

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

}  // namespace
}  // namespace toile
