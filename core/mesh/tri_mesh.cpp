// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

namespace toile {

std::shared_ptr<const TriMesh> buildTriMesh(const MeshArrays& mesh) {
    auto halfedges = std::make_shared<TriMesh>();
    const auto vertices = static_cast<std::size_t>(mesh.V.rows());
    const auto faces = static_cast<std::size_t>(mesh.F.rows());
    halfedges->reserve(vertices, vertices + faces, faces);  // a disk: E = V + F - 1
    for (int v = 0; v < mesh.V.rows(); ++v) {
        halfedges->new_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const auto face = halfedges->add_face(TriMesh::VertexHandle(mesh.F(f, 0)),
                                              TriMesh::VertexHandle(mesh.F(f, 1)),
                                              TriMesh::VertexHandle(mesh.F(f, 2)));
        if (!face.is_valid()) {
            return nullptr;
        }
    }
    return halfedges;
}

}  // namespace toile
