// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/metric_tensor.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

constexpr double kLargestEigenvalue = kLargestStretch * kLargestStretch;

MetricTensor bounded(const MetricTensor& metric) {
    // The larger eigenvalue is at most the trace.
    const double trace = metric.E + metric.G;
    if (!std::isfinite(trace) || !std::isfinite(metric.F)) {
        return {kLargestEigenvalue, 0, kLargestEigenvalue};
    }
    const double scale = trace > kLargestEigenvalue ? kLargestEigenvalue / trace : 1.0;
    return {scale * metric.E, scale * metric.F, scale * metric.G};
}

double doubleArea(const MeshArrays& mesh, Eigen::Index face) {
    const double area = doubleAreaNormal(mesh, face).norm();
    return std::isfinite(area) ? area : 0.0;
}

}  // namespace

MetricTensor unboundedMetric(const MeshArrays& mesh, const Points2& Q, Eigen::Index face) {
    const int a = mesh.F(face, 0), b = mesh.F(face, 1), c = mesh.F(face, 2);
    const Eigen::Vector3d X1 = (mesh.V.row(b) - mesh.V.row(a)).transpose();
    const Eigen::Vector3d X2 = (mesh.V.row(c) - mesh.V.row(a)).transpose();
    const Eigen::Vector2d u1 = (Q.row(b) - Q.row(a)).transpose();
    const Eigen::Vector2d u2 = (Q.row(c) - Q.row(a)).transpose();
    // Images of the x and y steps: [X1 X2] times the inverse of [u1 u2].
    const double determinant = geometry::cross(u1, u2);
    const Eigen::Vector3d alongX = (u2.y() * X1 - u1.y() * X2) / determinant;
    const Eigen::Vector3d alongY = (u1.x() * X2 - u2.x() * X1) / determinant;
    return {alongX.squaredNorm(), alongX.dot(alongY), alongY.squaredNorm()};
}

std::vector<MetricTensor> faceMetrics(const MeshArrays& mesh, const Points2& Q) {
    std::vector<MetricTensor> metrics;
    metrics.reserve(static_cast<std::size_t>(mesh.F.rows()));
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        metrics.push_back(bounded(unboundedMetric(mesh, Q, f)));
    }
    return metrics;
}

std::vector<MetricTensor> wornFaceMetrics(const MeshArrays& mesh, const Points2& Q) {
    std::vector<MetricTensor> metrics = faceMetrics(mesh, Q);
    const Eigen::VectorXd flatAreas = triangleAreas2d(Q, mesh.F);
    for (std::size_t f = 0; f < metrics.size(); ++f) {
        if (!(flatAreas[static_cast<Eigen::Index>(f)] > 0)) {
            metrics[f] = {kLargestEigenvalue, 0, kLargestEigenvalue};
        }
    }
    return metrics;
}

std::vector<MetricTensor> vertexMetrics(const MeshArrays& mesh,
                                        const std::vector<MetricTensor>& faces) {
    const auto count = static_cast<std::size_t>(mesh.V.rows());
    std::vector<MetricTensor> sums(count, MetricTensor{0, 0, 0});
    std::vector<double> weights(count, 0.0);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const MetricTensor& metric = faces[static_cast<std::size_t>(f)];
        const double area = doubleArea(mesh, f);
        for (int k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(mesh.F(f, k));
            sums[v].E += area * metric.E;
            sums[v].F += area * metric.F;
            sums[v].G += area * metric.G;
            weights[v] += area;
        }
    }
    for (std::size_t v = 0; v < count; ++v) {
        sums[v] = weights[v] > 0 ? MetricTensor{sums[v].E / weights[v], sums[v].F / weights[v],
                                                sums[v].G / weights[v]}
                                 : MetricTensor{};
    }
    return sums;
}

double strainAlong(const MetricTensor& metric, const Eigen::Vector2d& direction) {
    const double x = direction.x(), y = direction.y();
    const double square = metric.E * x * x + 2 * metric.F * x * y + metric.G * y * y;
    return std::sqrt(std::max(0.0, square)) - 1;
}

PrincipalStretch principalStretch(const MetricTensor& metric) {
    const double mean = (metric.E + metric.G) / 2;
    const double radius = std::hypot((metric.E - metric.G) / 2, metric.F);
    const double angle = std::atan2(2 * metric.F, metric.E - metric.G) / 2;
    return {std::sqrt(std::max(0.0, mean + radius)),
            std::sqrt(std::max(0.0, mean - radius)),
            {std::cos(angle), std::sin(angle)}};
}

double symmetricDirichlet(const MetricTensor& metric) {
    const double trace = metric.E + metric.G;
    const double determinant = metric.E * metric.G - metric.F * metric.F;
    const double energy = determinant > 0 ? trace * (1 + 1 / determinant) / 4 : kLargestEigenvalue;
    return std::min(energy, kLargestEigenvalue);
}

}  // namespace toile
