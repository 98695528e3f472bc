// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

#include <array>
#include <unordered_map>

#include "core/mesh/mesh_arrays.h"

namespace toile {

std::unique_ptr<TriMesh> buildTriMesh(const MeshArrays& mesh, const EdgeTable& table) {
    using Vertex = TriMesh::VertexHandle;
    using Halfedge = TriMesh::HalfedgeHandle;
    using Face = TriMesh::FaceHandle;
    const Triangles& F = mesh.F;
    auto edgeCount = static_cast<int>(table.edges.rows());
    std::vector<int> border;              // sides at walls
    std::unordered_map<int, int> parted;  // of these, those that get a new edge
    for (int e = 0; e < table.edges.rows(); ++e) {
        const std::span<const int> uses = table.usesOf(e);
        if (uses.size() == 2 && tailOf(F, uses[0]) != tailOf(F, uses[1])) {
            continue;
        }
        border.insert(border.end(), uses.begin(), uses.end());
        for (const int side : uses.subspan(1)) {
            parted[side] = edgeCount++;
        }
    }
    const auto along = [&](int side) {
        const int e = table.faceEdges.data()[side];
        const int own = parted.contains(side) ? parted.at(side) : e;
        return Halfedge(tailOf(F, side) == table.edges(e, 0) ? 2 * own : 2 * own + 1);
    };
    auto made = std::make_unique<TriMesh>();
    made->resize(static_cast<std::size_t>(mesh.V.rows()), static_cast<std::size_t>(edgeCount),
                 static_cast<std::size_t>(F.rows()));
    for (int v = 0; v < mesh.V.rows(); ++v) {
        made->set_point(Vertex(v), {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int f = 0; f < F.rows(); ++f) {
        const std::array<Halfedge, 3> round{along(3 * f), along(3 * f + 1), along(3 * f + 2)};
        for (int k = 0; k < 3; ++k) {
            made->set_face_handle(round[k], Face(f));
            made->set_vertex_handle(round[k], Vertex(F(f, (k + 1) % 3)));
            made->set_next_halfedge_handle(round[k], round[(k + 1) % 3]);
            made->set_halfedge_handle(Vertex(F(f, k)), round[k]);
        }
        made->set_halfedge_handle(Face(f), round[2]);  // the loop starts at its head
    }
    for (const int side : border) {
        const Halfedge back = made->opposite_halfedge_handle(along(side));
        made->set_vertex_handle(back, Vertex(tailOf(F, side)));
        made->set_halfedge_handle(Vertex(headOf(F, side)), back);
        Halfedge ahead = along(side);
        while (made->face_handle(ahead).is_valid()) {
            ahead = made->opposite_halfedge_handle(made->prev_halfedge_handle(ahead));
        }
        made->set_next_halfedge_handle(back, ahead);
    }
    return made;
}

}  // namespace toile
