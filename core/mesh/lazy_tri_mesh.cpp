// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lazy_tri_mesh.h"

#include "core/mesh/tri_mesh.h"

namespace toile {

const TriMesh& LazyTriMesh::get(const MeshArrays& mesh, const EdgeTable& table) const {
    std::call_once(built_, [&] { halfedges_ = buildTriMesh(mesh, table); });
    return *halfedges_;
}

}  // namespace toile
