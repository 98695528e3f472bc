// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>

#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// A mesh written out in a test: points in mm, and triangles by the points' numbers, from 0.
inline MeshArrays meshOf(std::initializer_list<Eigen::RowVector3d> points,
                         std::initializer_list<Eigen::RowVector3i> faces) {
    MeshArrays mesh{Points3(static_cast<int>(points.size()), 3),
                    Triangles(static_cast<int>(faces.size()), 3)};
    int row = 0;
    for (const auto& p : points) {
        mesh.V.row(row++) = p;
    }
    row = 0;
    for (const auto& f : faces) {
        mesh.F.row(row++) = f;
    }
    return mesh;
}

}  // namespace toile::test
