// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/label_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {

namespace {

constexpr Eigen::Index kCandidates = 250;
constexpr std::size_t kOutlineSamples = 400;
/// Along a band every place is as far from the outline: this much settles it for the middle.
constexpr double kPullToCentre = 0.3;

Eigen::Vector2d faceMiddle(const Points2& Q, const Triangles& F, Eigen::Index face) {
    return (Q.row(F(face, 0)) + Q.row(F(face, 1)) + Q.row(F(face, 2))).transpose() / 3.0;
}

double distanceToOutline(const Points2& Q, const std::vector<int>& boundary,
                         const Eigen::Vector2d& point) {
    const std::size_t step = std::max<std::size_t>(1, boundary.size() / kOutlineSamples);
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < boundary.size(); i += step) {
        least = std::min(least, (Q.row(boundary[i]).transpose() - point).squaredNorm());
    }
    return std::sqrt(least);
}

}  // namespace

Eigen::Vector2d labelPoint(const Points2& Q, const Triangles& F, const std::vector<int>& boundary) {
    const Eigen::Index step = std::max<Eigen::Index>(1, F.rows() / kCandidates);
    const Eigen::Vector2d centre = Q.colwise().mean().transpose();
    Eigen::Vector2d best = Eigen::Vector2d::Zero();
    double bestScore = std::numeric_limits<double>::lowest();
    for (Eigen::Index f = 0; f < F.rows(); f += step) {
        const Eigen::Vector2d middle = faceMiddle(Q, F, f);
        const double score =
            distanceToOutline(Q, boundary, middle) - kPullToCentre * (middle - centre).norm();
        if (score > bestScore) {
            best = middle;
            bestScore = score;
        }
    }
    return best;
}

}  // namespace toile
