// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct TriMeshTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};

/// Half-edge mesh of one piece, positions in millimetres. A class of its own so that headers can
/// declare it without paying for OpenMesh.
class TriMesh : public OpenMesh::TriMesh_ArrayKernelT<TriMeshTraits> {};

/// Builds the half-edge mesh of an oriented manifold with boundary (`isValidSurface`, or what
/// `checkDisk` has passed); same vertex, face and edge indices. Half-edge 2 e runs along edge e of
/// the table from its smaller vertex, 2 e + 1 back; as OpenMesh wants it, a vertex on the border
/// names the half-edge that leaves it along the border. A face's vertices go round in its own
/// order.
/// @param table  the edges of `mesh`
/// Cost: linear; every link is set once, which OpenMesh's own `add_face` takes ten times as long to
/// find.
std::shared_ptr<const TriMesh> buildTriMesh(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
