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

/// Half-edge mesh of one piece, positions in millimetres. A class of its own, so that headers can
/// declare it without including OpenMesh.
class TriMesh : public OpenMesh::TriMesh_ArrayKernelT<TriMeshTraits> {};

/// Builds the half-edge mesh of any triangles, with the same vertex, face and edge numbers. An edge
/// that does not join exactly two triangles of the same winding is a wall: all but the first of its
/// triangles get edges of their own, numbered after the others. Half-edge 2 e runs along edge e of
/// the table from its smaller vertex, 2 e + 1 back. A vertex on the border refers to a half-edge
/// that leaves it along the border, as OpenMesh requires. If several fans of triangles meet at a
/// vertex, it refers to a half-edge of one of them, and each fan's border is linked within the fan,
/// so that rims are closed loops. A face's vertices keep their order.
/// @param table  the edges of `mesh`
/// Cost: linear. OpenMesh's own `add_face` takes ten times as long to find the links.
std::unique_ptr<TriMesh> buildTriMesh(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
