// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "core/io/soup.h"
#include "core/mesh/disk_check.h"
#include "core/prepare/holes.h"
#include "tests/core/support/shapes.h"

namespace toile::test {

/// A skirt as a scan would have it: a tube of 150 mm radius and 600 mm height about the y axis, of
/// edges of about 10 mm.
inline constexpr double kSkirtRadius = 150;
inline constexpr double kSkirtHeight = 600;

inline MeshArrays skirt() {
    MeshArrays mesh = tube(94, 60);
    for (int v = 0; v < mesh.V.rows(); ++v) {
        mesh.V(v, 0) *= kSkirtRadius / 50;
        mesh.V(v, 1) *= kSkirtHeight / (60 * 20);
        mesh.V(v, 2) *= kSkirtRadius / 50;
    }
    return mesh;
}

/// Without what lies about this place, at its front.
inline MeshArrays withHole(const MeshArrays& mesh, double x, double y, double radius) {
    return part(mesh, [=](const Eigen::RowVector3d& middle) {
        return middle.z() < 0 || std::hypot(middle.x() - x, middle.y() - y) > radius;
    });
}

/// Each coordinate up to so much elsewhere.
inline MeshArrays withNoise(MeshArrays mesh, double most) {
    std::mt19937 random(11);
    for (Eigen::Index i = 0; i < mesh.V.size(); ++i) {
        mesh.V.data()[i] +=
            most *
            (2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1);
    }
    return mesh;
}

/// Both in one mesh, the second moved.
inline MeshArrays beside(const MeshArrays& a, const MeshArrays& b, const Eigen::RowVector3d& way) {
    MeshArrays both{Points3(a.V.rows() + b.V.rows(), 3), Triangles(a.F.rows() + b.F.rows(), 3)};
    both.V << a.V, b.V.rowwise() + way;
    both.F << a.F, b.F.array() + static_cast<int>(a.V.rows());
    return both;
}

/// As a file in centimetres would say it.
inline PolygonSoup inCentimetres(const MeshArrays& mesh) {
    PolygonSoup soup;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        soup.positions.emplace_back(mesh.V.row(v).transpose() / 10);
    }
    soup.corners.assign(mesh.F.data(), mesh.F.data() + mesh.F.size());
    for (int f = 0; f < mesh.F.rows(); ++f) {
        soup.faceStart.push_back(3 * (f + 1));
    }
    return soup;
}

inline EdgeTable edgesOf(const MeshArrays& mesh) {
    return buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
}

/// Perimeters of the rims, ascending.
inline std::vector<double> perimeters(const MeshArrays& mesh) {
    std::vector<double> lengths;
    for (const RimLoop& rim : rimsOf(mesh, edgesOf(mesh))) {
        lengths.push_back(rim.perimeter);
    }
    std::ranges::sort(lengths);
    return lengths;
}

inline double clothArea(const MeshArrays& mesh) {
    double area = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        area += doubleAreaNormal(mesh, f).norm() / 2;
    }
    return area;
}

/// How far the vertices lie from the skirt's cylinder: the mean, and the farthest.
struct OffSkirt {
    double mean = 0;
    double most = 0;
};

inline OffSkirt offSkirt(const Points3& V) {
    OffSkirt off;
    for (int v = 0; v < V.rows(); ++v) {
        const double distance = std::abs(std::hypot(V(v, 0), V(v, 2)) - kSkirtRadius);
        off.mean += distance / static_cast<double>(V.rows());
        off.most = std::max(off.most, distance);
    }
    return off;
}

}  // namespace toile::test
