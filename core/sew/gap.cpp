// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/gap.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace toile::sew {
SpreadFigures spreadOf(std::vector<SpreadSample> samples) {
    SpreadFigures figures;
    std::ranges::stable_sort(samples, {}, &SpreadSample::value);
    double whole = 0, sum = 0;
    for (const SpreadSample& sample : samples) {
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
    for (const SpreadSample& sample : samples) {
        figures.most95 = sample.value;
        below += sample.area;
        if (below >= 0.95 * whole) {
            break;
        }
    }
    return figures;
}

ClothGaps gapsTo(const WornSurface& surface, const Cloth& cloth, const Points3& X) {
    const auto distanceOf = [&](const Eigen::RowVector3d& p) {
        return surface.distanceTo(p.transpose());
    };
    const Eigen::VectorXd areas = restAreas(cloth);
    Eigen::VectorXd atVertex(X.rows());
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        atVertex[v] = distanceOf(X.row(v));
    }
    std::vector<SpreadSample> samples;
    samples.reserve(4 * static_cast<std::size_t>(cloth.F.rows()));
    std::vector<std::vector<SpreadSample>> ofPiece(pieceCount(cloth));
    for (int f = 0; f < static_cast<int>(cloth.F.rows()); ++f) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        const auto first = static_cast<std::ptrdiff_t>(samples.size());
        for (int k = 0; k < 3; ++k) {
            const int v = cloth.F(f, k);
            middle += X.row(v) / 3;
            samples.push_back({atVertex[v], areas[f] / 12, f});
        }
        samples.push_back({distanceOf(middle), areas[f] * 3 / 4, f});
        auto& own = ofPiece[cloth.pieceOf[f]];
        own.insert(own.end(), samples.begin() + first, samples.end());
    }
    ClothGaps gaps{spreadOf(std::move(samples)), {}};
    for (auto& own : ofPiece) {
        gaps.pieces.push_back(spreadOf(std::move(own)));
    }
    return gaps;
}

SpreadFigures gapTo(const WornSurface& surface, const Cloth& cloth, const Points3& X) {
    return gapsTo(surface, cloth, X).whole;
}

std::vector<double> principalStrains(const Cloth& cloth, const Points3& X) {
    const std::vector<RestShape> rest = restShapes(cloth);
    std::vector<double> strains;
    strains.reserve(rest.size());
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        const auto F = deformation(rest[f], cloth.F, f, X);
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
        solver.computeDirect(Eigen::Matrix2d(F.transpose() * F), Eigen::EigenvaluesOnly);
        const Eigen::Array2d strain = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().array() - 1;
        strains.push_back(std::abs(strain[0]) > std::abs(strain[1]) ? strain[0] : strain[1]);
    }
    return strains;
}

SpreadFigures strainOf(const Cloth& cloth, const Points3& X) {
    const std::vector<double> strains = principalStrains(cloth, X);
    const Eigen::VectorXd areas = restAreas(cloth);
    std::vector<SpreadSample> samples;
    samples.reserve(strains.size());
    for (int f = 0; f < static_cast<int>(cloth.F.rows()); ++f) {
        samples.push_back({std::abs(strains[f]), areas[f], f});
    }
    return spreadOf(std::move(samples));
}

}  // namespace toile::sew
