// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Sum of the triangles' areas, in the mesh's unit squared. Cost: linear. Pure.
inline double surfaceArea(const MeshArrays& mesh) {
    double doubled = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        doubled += doubleAreaNormal(mesh, f).norm();
    }
    return doubled / 2;
}

}  // namespace toile
