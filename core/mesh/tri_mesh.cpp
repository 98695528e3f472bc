// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

#include "core/mesh/mesh_arrays.h"

namespace toile {

std::shared_ptr<const TriMesh> buildTriMesh(const MeshArrays& mesh, const EdgeTable& table) {
    using Vertex = TriMesh::VertexHandle;
    using Halfedge = TriMesh::HalfedgeHandle;
    using Face = TriMesh::FaceHandle;
    auto made = std::make_shared<TriMesh>();
    made->resize(static_cast<std::size_t>(mesh.V.rows()),
                 static_cast<std::size_t>(table.edges.rows()),
                 static_cast<std::size_t>(mesh.F.rows()));
    for (int v = 0; v < mesh.V.rows(); ++v) {
        made->set_point(Vertex(v), {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int e = 0; e < table.edges.rows(); ++e) {
        made->set_vertex_handle(Halfedge(2 * e), Vertex(table.edges(e, 1)));
        made->set_vertex_handle(Halfedge(2 * e + 1), Vertex(table.edges(e, 0)));
    }
    const auto along = [&](int side) {
        const int e = table.faceEdges.data()[side];
        return Halfedge(tailOf(mesh.F, side) == table.edges(e, 0) ? 2 * e : 2 * e + 1);
    };
    for (int side = 0; side < mesh.F.size(); ++side) {
        made->set_face_handle(along(side), Face(side / 3));
        made->set_next_halfedge_handle(along(side), along(nextSide(side)));
        made->set_halfedge_handle(Vertex(tailOf(mesh.F, side)), along(side));
        made->set_halfedge_handle(Face(side / 3), along(side));  // the round starts at its head
    }
    std::vector<Halfedge> border;
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            const int side = table.usesOf(e)[0];
            border.push_back(made->opposite_halfedge_handle(along(side)));
            made->set_halfedge_handle(Vertex(headOf(mesh.F, side)), border.back());
        }
    }
    for (const Halfedge h : border) {
        made->set_next_halfedge_handle(h, made->halfedge_handle(made->to_vertex_handle(h)));
    }
    return made;
}

}  // namespace toile
