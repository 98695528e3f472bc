// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tri_mesh.h"

#include "core/mesh/lazy_tri_mesh.h"
#include "core/mesh/sides.h"

namespace toile {
namespace {

using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;
using Face = TriMesh::FaceHandle;

class Linker {
public:
    Linker(const MeshArrays& mesh, const EdgeTable& table, TriMesh& halfedges)
        : F_(mesh.F), table_(table), halfedges_(halfedges) {
        halfedges_.resize(static_cast<std::size_t>(mesh.V.rows()),
                          static_cast<std::size_t>(table.edges.rows()),
                          static_cast<std::size_t>(mesh.F.rows()));
        for (int v = 0; v < mesh.V.rows(); ++v) {
            halfedges_.set_point(Vertex(v), {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
        }
    }

    void run() {
        for (int e = 0; e < table_.edges.rows(); ++e) {
            halfedges_.set_vertex_handle(Halfedge(2 * e), Vertex(table_.edges(e, 1)));
            halfedges_.set_vertex_handle(Halfedge(2 * e + 1), Vertex(table_.edges(e, 0)));
        }
        for (int f = 0; f < F_.rows(); ++f) {
            linkFace(f);
        }
        linkBorder();
    }

private:
    Halfedge along(int side) const {
        const int e = table_.faceEdges.data()[side];
        return Halfedge(tailOf(F_, side) == table_.edges(e, 0) ? 2 * e : 2 * e + 1);
    }

    void linkFace(int f) {
        const Halfedge sides[3] = {along(3 * f), along(3 * f + 1), along(3 * f + 2)};
        for (int k = 0; k < 3; ++k) {
            halfedges_.set_face_handle(sides[k], Face(f));
            halfedges_.set_next_halfedge_handle(sides[k], sides[(k + 1) % 3]);
            halfedges_.set_halfedge_handle(Vertex(F_(f, k)), sides[k]);
        }
        halfedges_.set_halfedge_handle(Face(f), sides[2]);  // the round starts at its head
    }

    void linkBorder() {
        std::vector<Halfedge> border;
        for (int e = 0; e < table_.edges.rows(); ++e) {
            if (table_.useStart[e + 1] - table_.useStart[e] == 1) {
                const int side = table_.use[table_.useStart[e]];
                border.push_back(halfedges_.opposite_halfedge_handle(along(side)));
                halfedges_.set_halfedge_handle(Vertex(headOf(F_, side)), border.back());
            }
        }
        for (const Halfedge h : border) {
            halfedges_.set_next_halfedge_handle(
                h, halfedges_.halfedge_handle(halfedges_.to_vertex_handle(h)));
        }
    }

    const Triangles& F_;
    const EdgeTable& table_;
    TriMesh& halfedges_;
};

}  // namespace

std::shared_ptr<const TriMesh> buildTriMesh(const MeshArrays& mesh, const EdgeTable& table) {
    auto halfedges = std::make_shared<TriMesh>();
    Linker(mesh, table, *halfedges).run();
    return halfedges;
}

const TriMesh& LazyTriMesh::get(const MeshArrays& mesh, const EdgeTable& table) const {
    std::call_once(built_, [&] { halfedges_ = buildTriMesh(mesh, table); });
    return *halfedges_;
}

}  // namespace toile
