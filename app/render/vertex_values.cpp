// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/vertex_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/quality/piece_quality.h"

namespace toile {

namespace {

Eigen::Vector3d doubleAreaNormal(const MeshArrays& mesh, Eigen::Index face) {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0)).transpose();
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose();
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose();
    return (b - a).cross(c - a);
}

/// Weighted mean per vertex of values that lie on elements (rows of vertex indices).
template <class Elements>
Eigen::VectorXf averaged(const Elements& elements, const Eigen::VectorXd& values,
                         const Eigen::VectorXd& weights, Eigen::Index vertices, double unit) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(vertices);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(vertices);
    for (Eigen::Index e = 0; e < elements.rows(); ++e) {
        const double value = values[e] * unit;
        const double bounded =
            std::isnan(value) ? 0.0 : std::clamp(value, -kLargestValue, kLargestValue);
        for (Eigen::Index k = 0; k < elements.cols(); ++k) {
            sum[elements(e, k)] += weights[e] * bounded;
            weight[elements(e, k)] += weights[e];
        }
    }
    Eigen::VectorXf mean(vertices);
    for (Eigen::Index v = 0; v < vertices; ++v) {
        mean[v] = weight[v] > 0 ? static_cast<float>(sum[v] / weight[v]) : 0.0F;
    }
    return mean;
}

}  // namespace

VertexValues vertexValues(const Piece& piece, const Points2& Q) {
    const DistortionFields fields = distortionFields(piece, Q);
    const MeshArrays& mesh = piece.mesh;
    Eigen::VectorXd areas(mesh.F.rows());
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        areas[f] = doubleAreaNormal(mesh, f).norm();
    }
    Eigen::VectorXd lengths(piece.table.edges.rows());
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        lengths[e] =
            (mesh.V.row(piece.table.edges(e, 0)) - mesh.V.row(piece.table.edges(e, 1))).norm();
    }

    const Eigen::Index count = mesh.V.rows();
    constexpr double kPercent = 100.0, kDegrees = 180.0 / std::numbers::pi;
    return {averaged(mesh.F, fields.areaChange, areas, count, kPercent),
            averaged(mesh.F, fields.angleChange, areas, count, kDegrees),
            averaged(piece.table.edges, fields.edgeStrain, lengths, count, kPercent)};
}

Points3 vertexNormals(const MeshArrays& mesh) {
    Points3 normals = Points3::Zero(mesh.V.rows(), 3);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3d normal = doubleAreaNormal(mesh, f).transpose();
        for (int k = 0; k < 3; ++k) {
            normals.row(mesh.F(f, k)) += normal;
        }
    }
    for (Eigen::Index v = 0; v < normals.rows(); ++v) {
        const double length = normals.row(v).norm();
        if (length > 0 && std::isfinite(length)) {
            normals.row(v) /= length;
        } else {
            normals.row(v) << 0, 0, 1;
        }
    }
    return normals;
}

}  // namespace toile
