// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/surface_point.h"

namespace toile {

Eigen::Vector3d positionOf(const MeshArrays& mesh, const SurfacePoint& point) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += point.barycentric[k] * mesh.V.row(mesh.F(point.face, k)).transpose();
    }
    return sum;
}

double measuredLength(const MeshArrays& mesh, const PathPolyline& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        sum += (positionOf(mesh, path.points[i]) - positionOf(mesh, path.points[i - 1])).norm();
    }
    return sum;
}

}  // namespace toile
