// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "core/garment/fabric_stiffness.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The cloth that a piece is cut from, as an input of flattening. An energy that is alike in all
/// directions ignores it.
struct PieceCloth {
    /// Direction of the warp in the garment's space: one row for the whole piece, or one per vertex
    /// (any length, zero where unknown); no rows: unknown. Its sign does not matter.
    Points3 warp{};
    Fabric fabric = fabricPresets().front();        ///< limits of strain per direction
    ClothStiffness stiffness = kUnstatedStiffness;  ///< resistance per direction

    bool operator==(const PieceCloth& other) const {
        return warp.rows() == other.warp.rows() && warp == other.warp && fabric == other.fabric &&
               stiffness == other.stiffness;
    }
};

/// Shared and immutable; null: nothing is known.
using PieceClothPointer = std::shared_ptr<const PieceCloth>;
using PieceCloths = std::vector<PieceClothPointer>;  ///< one per piece

inline bool isSameCloth(const PieceClothPointer& a, const PieceClothPointer& b) {
    return a == b || (a && b && *a == *b);
}

/// The warp in a triangle: the part of its corners' mean direction that lies in its plane; zero if
/// unknown. For the direction "up" this is the gradient of the height.
/// @param mesh  of the piece, which may have more vertices (caps of holes) than rows of `warp`
inline Eigen::Vector3d warpIn(const PieceCloth& cloth, const MeshArrays& mesh, Eigen::Index f) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Index row = cloth.warp.rows() == 1 ? 0 : mesh.F(f, k);
        if (row < cloth.warp.rows()) {
            mean += cloth.warp.row(row).transpose() / 3;
        }
    }
    const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
    const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
    const Eigen::Vector3d normal = a.cross(b).normalized();
    return mean - mean.dot(normal) * normal;
}

}  // namespace toile
