// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The sides of triangles: side 3 * f + k runs from corner k of face f to the next.

inline int nextSide(int side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

inline int previousSide(int side) {
    return side % 3 == 0 ? side + 2 : side - 1;
}

inline int tailOf(const Triangles& F, int side) {
    return F.data()[side];
}

inline int headOf(const Triangles& F, int side) {
    return F.data()[nextSide(side)];
}

inline int apexOf(const Triangles& F, int side) {
    return F.data()[previousSide(side)];
}

/// At right angles to a triangle, towards the side from which it runs anti-clockwise, and twice its
/// area long.
inline Eigen::Vector3d doubleAreaNormal(const MeshArrays& mesh, Eigen::Index face) {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0)).transpose();
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose();
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose();
    return (b - a).cross(c - a);
}

}  // namespace toile
