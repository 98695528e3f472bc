// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::symmetry {

/// Pieces of a garment as a single triangle mesh, mm; seams are not joined.
struct GarmentSurface {
    MeshArrays mesh;
    std::vector<int> pieceOfVertex;   ///< #V
    std::vector<int> pieceOfFace;     ///< #F
    Eigen::VectorXd area;             ///< #V, a third of the triangles at each vertex, mm^2
    Eigen::Vector3d centre{0, 0, 0};  ///< of the area
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< mean of the centred x x^T, mm^2

    /// Root mean square distance from the centre, mm: the garment's size, in any orientation.
    double radius() const;
    /// Evenly chosen vertices, at most `most`. Deterministic.
    std::vector<int> sampled(int most) const;
};

/// Precondition: finite positions.  Cost: linear. Pure.
GarmentSurface surfaceOf(const Pieces& pieces);

}  // namespace toile::symmetry
