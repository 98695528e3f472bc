// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/holes.h"

namespace toile {
namespace {

constexpr double kFlatness = 0.5;  // minimum for a hole

}  // namespace

double flatness(const MeshArrays& mesh, const EdgeTable& table, const RimLoop& rim) {
    const auto point = [&mesh, &rim](std::size_t i) -> Eigen::Vector3d {
        return mesh.V.row(rim.vertices[i % rim.vertices.size()]).transpose();
    };
    const Eigen::Vector3d origin = point(0);  // avoids cancellation far from the origin
    Eigen::Vector3d area = Eigen::Vector3d::Zero(), cloth = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
        // A patch has the opposite direction of the rim, which has the cloth on its left.
        area -= (point(i) - origin).cross(point(i + 1) - origin);
        const int tail = rim.vertices[i], head = rim.vertices[(i + 1) % rim.vertices.size()];
        const int face = table.usesOf(findEdge(table.edges, tail, head)).front() / 3;
        cloth += (point(i + 1) - point(i)).norm() * doubleAreaNormal(mesh, face).normalized();
    }
    return rim.perimeter > 0 ? area.normalized().dot(cloth) / rim.perimeter : 0;
}

std::vector<RimLoop> findHoles(const MeshArrays& mesh, const EdgeTable& table, double largest) {
    std::vector<RimLoop> holes = rimsOf(mesh, table);
    std::erase_if(holes, [&](const RimLoop& rim) {
        return rim.perimeter > largest || flatness(mesh, table, rim) < kFlatness;
    });
    return holes;
}

}  // namespace toile
