// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/metric_tensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"
#include "core/quality/piece_quality.h"

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

namespace {

constexpr double kLargestSquare = 16;  // squared stretch beyond which a triangle counts as torn
constexpr double kTieWeight = 1e-3;    // weight of squared strain relative to squared excess
constexpr double kStiffest = 0.001;    // smallest strain limit in weights: no cloth is stiffer

/// How the cloth of one triangle is stretched along each direction of the flat piece: the squared
/// stretch along angle t is mean + cosine cos 2t + sine sin 2t.
struct Stretch {
    double area = 0;  ///< worn area
    double mean = 0, cosine = 0, sine = 0;
};

/// Stretch of a triangle; zero area if it cannot be measured.
Stretch stretchOf(const MeshArrays& mesh, const Points2& Q, Eigen::Index face) {
    const MetricTensor metric = unboundedMetric(mesh, Q, face);
    Stretch stretch{0.5 * doubleAreaNormal(mesh, face).norm(), 0.5 * (metric.E + metric.G),
                    0.5 * (metric.E - metric.G), metric.F};
    const double largest = stretch.mean + std::hypot(stretch.cosine, stretch.sine);
    if (!std::isfinite(largest) || !std::isfinite(stretch.area)) {
        return {};
    }
    if (largest > kLargestSquare) {
        const double scale = kLargestSquare / largest;
        stretch.mean *= scale;
        stretch.cosine *= scale;
        stretch.sine *= scale;
    }
    return stretch;
}

/// Limits of the cloth along one direction.
struct Along {
    double cosine, sine;  ///< of twice its angle
    StrainLimits limits;
    double weight;  ///< of squared strain within the limits
};

class Cost {
public:
    explicit Cost(const Fabric& fabric) : fabric_(fabric) {
        const auto give = [](const StrainLimits& limits) -> double {
            return std::max({kStiffest, limits.most, -limits.least});
        };
        const double least = std::min({give(fabric.warp), give(fabric.weft), give(fabric.bias)});
        const auto weight = [&](const StrainLimits& limits) -> double {
            return kTieWeight * (least / give(limits)) * (least / give(limits));
        };
        weights_ = {weight(fabric.warp), weight(fabric.weft), 0.5 * weight(fabric.bias)};
    }

    double operator()(const std::vector<Stretch>& stretches, double angle) const {
        const double c = std::cos(2 * angle), s = std::sin(2 * angle);
        // Weft lies across the warp, the two biases at half a right angle on either side.
        const std::array<Along, 4> ways{
            Along{c, s, fabric_.warp, weights_[0]}, Along{-c, -s, fabric_.weft, weights_[1]},
            Along{-s, c, fabric_.bias, weights_[2]}, Along{s, -c, fabric_.bias, weights_[2]}};
        double cost = 0, area = 0;
        for (const Stretch& stretch : stretches) {
            double of = 0;
            for (std::size_t i = 0; i < ways.size(); ++i) {
                const Along& way = ways[i];
                const double square =
                    stretch.mean + stretch.cosine * way.cosine + stretch.sine * way.sine;
                const double strain = std::sqrt(std::max(0.0, square)) - 1;
                const double beyond =
                    std::max({0.0, strain - way.limits.most, way.limits.least - strain});
                of += (i < 2 ? 1.0 : 0.5) * beyond * beyond + way.weight * strain * strain;
            }
            cost += stretch.area * of;
            area += stretch.area;
        }
        return area > 0 ? cost / area : 0.0;
    }

private:
    const Fabric& fabric_;
    std::array<double, 3> weights_{};
};

}  // namespace

double grainCost(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric, double angle) {
    std::vector<Stretch> stretches;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        if (const Stretch stretch = stretchOf(mesh, Q, f); stretch.area > 0) {
            stretches.push_back(stretch);
        }
    }
    return Cost(fabric)(stretches, angle);
}

StrainedArea strainedArea(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                          double angle) {
    const auto metrics = wornFaceMetrics(mesh, Q);
    const Eigen::VectorXd areas = triangleAreas2d(Q, mesh.F);
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d across(-along.y(), along.x());
    const StrainBounds warp(fabric.warp), weft(fabric.weft), bias(fabric.bias);
    StrainedArea sum;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const MetricTensor& metric = metrics[static_cast<std::size_t>(f)];
        const double area = std::isfinite(areas[f]) ? std::abs(areas[f]) : 0;
        const auto strain = [&metric](const Eigen::Vector2d& way) -> double {
            return strainAlong(metric, way.normalized());
        };
        const bool beyond = warp.isBeyond(strain(along)) || weft.isBeyond(strain(across)) ||
                            bias.isBeyond(strain(along + across)) ||
                            bias.isBeyond(strain(along - across));
        sum.all += area;
        sum.beyond += beyond && hasLimits(fabric) ? area : 0;
    }
    return sum;
}

}  // namespace toile
