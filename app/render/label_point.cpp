// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/label_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/garment/piece.h"

namespace toile {

namespace {

constexpr Eigen::Index kCandidates = 250;
constexpr std::size_t kEdgeSamples = 400;  ///< of the outline, and of all rims
constexpr std::size_t kRimSamples = 8;     ///< of each rim at least
/// Along a band every place is as far from the outline: this much settles it for the middle.
constexpr double kPullToCentre = 0.3;
/// A piece is narrow where the cloth about its name is less wide than this part of its extent, and
/// its arrow goes this part of its extent away from the name.
constexpr double kNarrow = 0.4, kBeside = 0.2;
constexpr double kPullToLabel = 0.1;

Eigen::Vector2d faceMiddle(const Points2& Q, const Triangles& F, Eigen::Index face) {
    return (Q.row(F(face, 0)) + Q.row(F(face, 1)) + Q.row(F(face, 2))).transpose() / 3.0;
}

/// Some vertices of the outline and the rims of holes.
std::vector<Eigen::Vector2d> edgePoints(const Piece& piece, const Points2& Q) {
    std::vector<Eigen::Vector2d> points;
    const auto add = [&](const std::vector<int>& loop, std::size_t samples) {
        const std::size_t step = std::max<std::size_t>(1, loop.size() / samples);
        for (std::size_t i = 0; i < loop.size(); i += step) {
            points.emplace_back(Q.row(loop[i]));
        }
    };
    add(piece.boundary, kEdgeSamples);
    for (const auto& rim : piece.holes) {
        add(rim, std::max(kRimSamples, kEdgeSamples / piece.holes.size()));
    }
    return points;
}

double distanceTo(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& place) {
    double least = std::numeric_limits<double>::max();
    for (const Eigen::Vector2d& point : points) {
        least = std::min(least, (point - place).squaredNorm());
    }
    return std::sqrt(least);
}

}  // namespace

Eigen::Vector2d labelPoint(const Piece& piece, const Points2& Q) {
    const Triangles& F = piece.mesh.F;
    const auto edges = edgePoints(piece, Q);
    const Eigen::Index step = std::max<Eigen::Index>(1, F.rows() / kCandidates);
    const Eigen::Vector2d centre = Q.colwise().mean().transpose();
    Eigen::Vector2d best = Eigen::Vector2d::Zero();
    double bestScore = std::numeric_limits<double>::lowest();
    for (Eigen::Index f = 0; f < F.rows(); f += step) {
        const Eigen::Vector2d middle = faceMiddle(Q, F, f);
        const double score = distanceTo(edges, middle) - kPullToCentre * (middle - centre).norm();
        if (score > bestScore) {
            best = middle;
            bestScore = score;
        }
    }
    return best;
}

Eigen::Vector2d arrowPoint(const Piece& piece, const Points2& Q, const Eigen::Vector2d& label) {
    const Triangles& F = piece.mesh.F;
    const auto edges = edgePoints(piece, Q);
    const double extent = (Q.colwise().maxCoeff() - Q.colwise().minCoeff()).norm();
    if (2 * distanceTo(edges, label) >= kNarrow * extent) {
        return label;
    }
    const Eigen::Index step = std::max<Eigen::Index>(1, F.rows() / kCandidates);
    Eigen::Vector2d best = label;
    double bestScore = std::numeric_limits<double>::lowest();
    for (Eigen::Index f = 0; f < F.rows(); f += step) {
        const Eigen::Vector2d middle = faceMiddle(Q, F, f);
        const double away = (middle - label).norm();
        const double score = distanceTo(edges, middle) - kPullToLabel * away;
        if (away >= kBeside * extent && score > bestScore) {
            best = middle;
            bestScore = score;
        }
    }
    return best;
}

}  // namespace toile
