// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A tree of the mesh's triangles in double precision.
inline geometry::TriangleTree<3, double> treeOf(const MeshArrays& mesh) {
    return {mesh.V.data(),
            3,
            {reinterpret_cast<const std::uint32_t*>(mesh.F.data()),  // indices are not negative
             static_cast<std::size_t>(mesh.F.size())}};
}

/// The mesh's point closest to `p`; of equally close ones, that on the face with the smallest
/// index. For classes that query repeatedly.
/// @param tree  `treeOf` the mesh  @param near  a face nearby, or -1: speeds up the search
inline SurfacePoint nearestOn(const MeshArrays& mesh, const geometry::TriangleTree<3, double>& tree,
                              const Eigen::Vector3d& p, int near = -1) {
    // Squared distances that differ by more than this differ under any rounding.
    constexpr double kSurely = 1 + 1e-6, kSmall = 1e-12;
    const auto squareTo = [&p](const auto& low, const auto& high) {
        return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
    };
    SurfacePoint best{0, {1, 0, 0}};  // so far away that no distance is finite
    double least = std::numeric_limits<double>::infinity();
    const auto visit = [&](std::uint32_t triangle) {
        const int f = static_cast<int>(triangle);
        const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
                              c = mesh.V.row(mesh.F(f, 2));
        if (squareTo(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)) >
            kSurely * least + kSmall) {
            return;
        }
        const SurfacePoint point{f, nearestInTriangle(p, a, b, c)};
        const double distance = (positionOf(mesh, point) - p).squaredNorm();
        if (distance < least || (distance == least && f < best.face)) {
            least = distance;
            best = point;
        }
    };
    if (near >= 0) {
        visit(static_cast<std::uint32_t>(near));
    }
    const auto distanceTo = [&](const auto& box) {
        const Eigen::Map<const Eigen::Vector3d> low(box.low.data()), high(box.high.data());
        const double distance = squareTo(low, high);
        return distance > least ? geometry::TriangleTree<3, double>::kMissed : distance;
    };
    tree.search(distanceTo, visit);
    return best;
}

}  // namespace toile
