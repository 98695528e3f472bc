// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

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

/// Builds the half-edge mesh of arrays that have passed `checkDisk`; same vertex and face indices.
/// Returns nothing where OpenMesh refuses a face, which after that check would be a bug.
std::shared_ptr<const TriMesh> buildTriMesh(const MeshArrays& mesh);

}  // namespace toile
