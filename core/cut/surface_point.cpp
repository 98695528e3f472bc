// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/surface_point.h"

#include "core/cut/nearest_search.h"

namespace toile {

double measuredLength(const MeshArrays& mesh, const PathPolyline& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        sum += (positionOf(mesh, path.points[i]) - positionOf(mesh, path.points[i - 1])).norm();
    }
    return sum;
}

Eigen::Vector3d nearestInTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0 && d2 <= 0) {
        return {1, 0, 0};
    }
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0 && d4 <= d3) {
        return {0, 1, 0};
    }
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0 && d5 <= d6) {
        return {0, 0, 1};
    }
    const double onAb = d1 * d4 - d3 * d2;
    if (onAb <= 0 && d1 >= 0 && d3 <= 0) {
        const double t = d1 / (d1 - d3);
        return {1 - t, t, 0};
    }
    const double onAc = d5 * d2 - d1 * d6;
    if (onAc <= 0 && d2 >= 0 && d6 <= 0) {
        const double t = d2 / (d2 - d6);
        return {1 - t, 0, t};
    }
    const double onBc = d3 * d6 - d5 * d4;
    if (onBc <= 0 && d4 >= d3 && d5 >= d6) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const double sum = onAb + onAc + onBc;
    const Eigen::Vector3d weights(0, onAc / sum, onAb / sum);
    return {1 - weights[1] - weights[2], weights[1], weights[2]};
}

NearestSurface::NearestSurface(const MeshArrays& mesh) : mesh_(mesh), tree_(treeOf(mesh)) {}

SurfacePoint NearestSurface::find(const Eigen::Vector3d& p) const {
    return nearestOn(mesh_, tree_, p);
}

}  // namespace toile
