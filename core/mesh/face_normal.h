// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// At right angles to a triangle, towards the side from which it runs anti-clockwise, and twice its
/// area long.
inline Eigen::Vector3d doubleAreaNormal(const MeshArrays& mesh, Eigen::Index face) {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0)).transpose();
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose();
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose();
    return (b - a).cross(c - a);
}

}  // namespace toile
