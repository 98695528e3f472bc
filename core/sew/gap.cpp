// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/gap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

namespace toile::sew {
namespace {

struct Sample {
    double value, area;
    int triangle;
};

SpreadFigures spread(std::vector<Sample> samples) {
    SpreadFigures figures;
    std::ranges::stable_sort(samples, {}, &Sample::value);
    double whole = 0, sum = 0;
    for (const Sample& sample : samples) {
        whole += sample.area;
        sum += sample.area * sample.value;
    }
    if (samples.empty() || !(whole > 0)) {
        return figures;
    }
    figures.mean = sum / whole;
    figures.max = samples.back().value;
    figures.place = samples.back().triangle;
    double below = 0;
    for (const Sample& sample : samples) {
        figures.most95 = sample.value;
        below += sample.area;
        if (below >= 0.95 * whole) {
            break;
        }
    }
    return figures;
}

}  // namespace

SpreadFigures gapTo(const WornSurface& surface, const Cloth& cloth, const Points3& X) {
    const auto distanceOf = [&](const Eigen::RowVector3d& p) {
        return surface.distanceTo(p.transpose());
    };
    const Eigen::VectorXd areas = restAreas(cloth);
    std::vector<double> atVertex(static_cast<std::size_t>(X.rows()));
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        atVertex[v] = distanceOf(X.row(v));
    }
    std::vector<Sample> samples;
    samples.reserve(4 * static_cast<std::size_t>(cloth.F.rows()));
    for (int f = 0; f < static_cast<int>(cloth.F.rows()); ++f) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            const int v = cloth.F(f, k);
            middle += X.row(v) / 3;
            samples.push_back({atVertex[v], areas[f] / 12, f});
        }
        samples.push_back({distanceOf(middle), areas[f] * 3 / 4, f});
    }
    return spread(std::move(samples));
}

SpreadFigures strainOf(const Cloth& cloth, const Points3& X) {
    const std::vector<RestShape> rest = restShapes(cloth);
    std::vector<Sample> samples;
    for (int f = 0; f < static_cast<int>(cloth.F.rows()); ++f) {
        const auto F = deformation(rest[f], cloth.F, f, X);
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
        solver.computeDirect(Eigen::Matrix2d(F.transpose() * F), Eigen::EigenvaluesOnly);
        const Eigen::Array2d stretch = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
        samples.push_back({(stretch - 1).abs().maxCoeff(), rest[f].area, f});
    }
    return spread(std::move(samples));
}

}  // namespace toile::sew
