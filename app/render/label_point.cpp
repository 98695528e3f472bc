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
/// A piece is narrow where the cloth about its name is less wide than this part of its extent, and
/// its arrow goes this part of its extent away from the name.
constexpr double kNarrow = 0.4, kBeside = 0.2;
constexpr double kPullToLabel = 0.1;

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

Eigen::Vector2d arrowPoint(const Points2& Q, const Triangles& F, const std::vector<int>& boundary,
                           const Eigen::Vector2d& label) {
    const double extent = (Q.colwise().maxCoeff() - Q.colwise().minCoeff()).norm();
    if (2 * distanceToOutline(Q, boundary, label) >= kNarrow * extent) {
        return label;
    }
    const Eigen::Index step = std::max<Eigen::Index>(1, F.rows() / kCandidates);
    Eigen::Vector2d best = label;
    double bestScore = std::numeric_limits<double>::lowest();
    for (Eigen::Index f = 0; f < F.rows(); f += step) {
        const Eigen::Vector2d middle = faceMiddle(Q, F, f);
        const double away = (middle - label).norm();
        const double score = distanceToOutline(Q, boundary, middle) - kPullToLabel * away;
        if (away >= kBeside * extent && score > bestScore) {
            best = middle;
            bestScore = score;
        }
    }
    return best;
}

}  // namespace toile
