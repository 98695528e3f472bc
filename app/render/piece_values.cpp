// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/piece_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"

namespace toile::app {

namespace {

double bounded(double value) {
    return std::isnan(value) ? 0.0 : std::clamp(value, -kLargestValue, kLargestValue);
}

/// Weighted mean at each vertex of the values of its triangles.
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

/// Converts A2D/A3D - 1 to A3D/A2D - 1, the change of the cloth when worn, as for strain.
Eigen::VectorXd areaToGain(const Eigen::VectorXd& areaChange) {
    return areaChange.unaryExpr([](double change) -> double { return 1 / (1 + change) - 1; });
}

/// The largest or smallest edge strain of each triangle.
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

std::vector<int> outlineCorners(const Piece& piece) {
    const auto& [V, F] = piece.mesh;
    std::vector<int> placeOf(static_cast<std::size_t>(V.rows()), -1);
    for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
        placeOf[static_cast<std::size_t>(piece.boundary[k])] = static_cast<int>(k);
    }
    // The turn of the outline at a vertex is the cloth's angle there minus 180 degrees.
    std::vector<double> angles(piece.boundary.size(), 0.0);
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int place = placeOf[static_cast<std::size_t>(F(f, k))];
            if (place < 0) {
                continue;
            }
            const Eigen::Vector3d a = V.row(F(f, k)), b = V.row(F(f, (k + 1) % 3)),
                                  c = V.row(F(f, (k + 2) % 3));
            angles[static_cast<std::size_t>(place)] +=
                std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
        }
    }
    std::vector<int> corners;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        if (std::abs(std::numbers::pi - angles[k]) > kCornerTurn) {
            corners.push_back(static_cast<int>(k));
        }
    }
    return corners;
}

OutlineRun runBetweenCorners(const std::vector<int>& corners, int size, int edge) {
    if (corners.size() < 2) {
        return {corners.empty() ? 0 : corners.front(), size};
    }
    const auto next = std::ranges::upper_bound(corners, edge);
    const int end = next == corners.end() ? corners.front() + size : *next;
    const int begin = next == corners.begin() ? corners.back() - size : *std::prev(next);
    return {(begin + size) % size, end - begin};
}

}  // namespace toile::app
