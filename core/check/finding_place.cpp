// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/finding_place.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "core/mesh/sides.h"

namespace toile {
namespace {

/// Unit length, or zero where there is no direction.
Eigen::Vector3d unit(const Eigen::Vector3d& v) {
    const double length = v.norm();
    return length > 0 ? Eigen::Vector3d(v / length) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d vertexNormal(const MeshArrays& mesh, int vertex) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        if ((mesh.F.row(f).array() == vertex).any()) {
            sum += doubleAreaNormal(mesh, f);
        }
    }
    return unit(sum);
}

}  // namespace

FindingPlace placeAtVertex(const Piece& piece, const Points2& Q, int vertex) {
    return {Q.row(vertex).transpose(), piece.mesh.V.row(vertex).transpose(),
            vertexNormal(piece.mesh, vertex)};
}

FindingPlace placeInTriangle(const Piece& piece, const Points2& Q, Eigen::Index face) {
    FindingPlace place;
    for (int k = 0; k < 3; ++k) {
        place.flat += Q.row(piece.mesh.F(face, k)).transpose() / 3;
        place.position += piece.mesh.V.row(piece.mesh.F(face, k)).transpose() / 3;
    }
    place.normal = unit(doubleAreaNormal(piece.mesh, face));
    return place;
}

FindingPlace placeOnOutline(const Piece& piece, const Points2& Q, int edge,
                            const Eigen::RowVector2d& flat) {
    const auto n = piece.boundary.size();
    const int v = piece.boundary[static_cast<std::size_t>(edge)];
    const int w = piece.boundary[(static_cast<std::size_t>(edge) + 1) % n];
    const double length = (Q.row(w) - Q.row(v)).norm();
    const double share = length > 0 ? std::min(1.0, (flat - Q.row(v)).norm() / length) : 0;
    FindingPlace place = placeAtVertex(piece, Q, v);
    place.flat = flat.transpose();
    place.position = ((1 - share) * piece.mesh.V.row(v) + share * piece.mesh.V.row(w)).transpose();
    return place;
}

}  // namespace toile
