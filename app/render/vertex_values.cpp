// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/vertex_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/mesh/sides.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"

namespace toile {

namespace {

double bounded(double value) {
    return std::isnan(value) ? 0.0 : std::clamp(value, -kLargestValue, kLargestValue);
}

/// Mean per vertex of the values of the triangles around it.
Eigen::VectorXf averaged(const Triangles& F, const Eigen::VectorXf& values,
                         const Eigen::VectorXd& weights, Eigen::Index vertices) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(vertices);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(vertices);
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum[F(f, k)] += weights[f] * static_cast<double>(values[f]);
            weight[F(f, k)] += weights[f];
        }
    }
    Eigen::VectorXf mean(vertices);
    for (Eigen::Index v = 0; v < vertices; ++v) {
        mean[v] = weight[v] > 0 ? static_cast<float>(sum[v] / weight[v]) : 0.0F;
    }
    return mean;
}

Eigen::VectorXf inUnit(const Eigen::VectorXd& values, double unit) {
    return values.unaryExpr([unit](double value) -> double { return bounded(value * unit); })
        .cast<float>();
}

/// A3D/A2D - 1 of what is given as A2D/A3D - 1: what the cloth must do, as strain has it.
Eigen::VectorXd areaToGain(const Eigen::VectorXd& areaChange) {
    return areaChange.unaryExpr([](double change) -> double { return 1 / (1 + change) - 1; });
}

/// Per triangle the largest or the least of its edges' strains.
Eigen::VectorXd ofEdges(const Piece& piece, const Eigen::VectorXd& edgeStrain, bool largest) {
    const Triangles& edges = piece.table.faceEdges;
    Eigen::VectorXd strains(edges.rows());
    for (Eigen::Index f = 0; f < edges.rows(); ++f) {
        const double a = edgeStrain[edges(f, 0)], b = edgeStrain[edges(f, 1)],
                     c = edgeStrain[edges(f, 2)];
        strains[f] = largest ? std::max({a, b, c}) : std::min({a, b, c});
    }
    return strains;
}

}  // namespace

PieceValues pieceValues(const Piece& piece, const Points2& Q) {
    const DistortionFields fields = distortionFields(piece, Q);
    const MeshArrays& mesh = piece.mesh;
    Eigen::VectorXd areas(mesh.F.rows());
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        areas[f] = doubleAreaNormal(mesh, f).norm();
    }
    const Eigen::Index count = mesh.V.rows();
    constexpr double kPercent = 100.0, kDegrees = 180.0 / std::numbers::pi;
    const Eigen::VectorXd flatAreas = triangleAreas2d(Q, mesh.F);
    const Eigen::VectorXd areaChange = areaToGain(fields.areaChange);
    PieceValues values;
    values.faces = {inUnit(areaChange, kPercent), inUnit(fields.angleChange, kDegrees),
                    inUnit(ofEdges(piece, fields.edgeStrain, true), kPercent),
                    inUnit(ofEdges(piece, fields.edgeStrain, false), kPercent),
                    wornFaceMetrics(mesh, Q)};
    const auto smoothed = [&](const Eigen::VectorXf& of) -> Eigen::VectorXf {
        return averaged(mesh.F, of, areas, count);
    };
    values.vertices = {smoothed(values.faces.area), smoothed(values.faces.angle),
                       smoothed(values.faces.mostStrain), smoothed(values.faces.leastStrain),
                       vertexMetrics(mesh, values.faces.metric)};
    values.flatAreas = inUnit(flatAreas.cwiseAbs(), 1);
    return values;
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
