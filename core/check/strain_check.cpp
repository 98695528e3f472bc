// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/strain_check.h"

#include <algorithm>
#include <cmath>

#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"

namespace toile {
namespace {

/// A limit of 0 would make rounding a fault.
constexpr double kLeastLimit = 1e-4;
/// Nor may rounding put cloth that is just at its limit beyond it: as the window's colour bar.
constexpr double kSlack = 1.0005;

struct Limits {
    explicit Limits(const StrainLimits& stated)
        : least(std::min(stated.least, -kLeastLimit)), most(std::max(stated.most, kLeastLimit)) {}

    double limitFor(double strain) const { return strain < 0 ? least : most; }
    double severity(double strain) const { return strain / limitFor(strain); }

    double least, most;
};

/// Gathers one direction over the triangles.
class Tally {
public:
    explicit Tally(const StrainLimits& stated) : limits_(stated) {}

    double severity(double strain) const { return limits_.severity(strain); }

    void add(int face, double strain, double area) {
        const double severity = limits_.severity(strain);
        total_ += area;
        beyond_ += severity > kSlack ? area : 0;
        if (severity > worst_.severity) {
            worst_ = {0, face, strain, limits_.limitFor(strain), severity};
        }
    }

    StrainExcess result() const {
        StrainExcess excess = worst_;
        // Cloth that has collapsed has no area, and is beyond all the same.
        excess.share = total_ > 0 ? beyond_ / total_ : worst_.severity > kSlack ? 1 : 0;
        return excess;
    }

private:
    Limits limits_;
    double total_ = 0, beyond_ = 0;
    StrainExcess worst_;
};

}  // namespace

StrainExcesses strainExcesses(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                              double grain) {
    const auto metrics = wornFaceMetrics(mesh, Q);
    const Eigen::VectorXd areas = triangleAreas2d(Q, mesh.F);
    const Eigen::Vector2d along(std::cos(grain), std::sin(grain));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d rising = (along + across) * std::sqrt(0.5);
    const Eigen::Vector2d falling = (along - across) * std::sqrt(0.5);
    Tally warp(fabric.warp), weft(fabric.weft), bias(fabric.bias);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const MetricTensor& metric = metrics[static_cast<std::size_t>(f)];
        const int face = static_cast<int>(f);
        const double area = std::isfinite(areas[f]) ? std::abs(areas[f]) : 0;
        warp.add(face, strainAlong(metric, along), area);
        weft.add(face, strainAlong(metric, across), area);
        const double up = strainAlong(metric, rising), down = strainAlong(metric, falling);
        bias.add(face, bias.severity(up) >= bias.severity(down) ? up : down, area);
    }
    return {warp.result(), weft.result(), bias.result()};
}

}  // namespace toile
