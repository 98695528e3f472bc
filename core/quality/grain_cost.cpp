// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/grain_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/units.h"
#include "core/mesh/mesh_arrays.h"
#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"
#include "core/quality/piece_quality.h"

namespace toile {
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
