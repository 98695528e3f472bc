// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/body_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"
#include "core/cut/surface_paths.h"

namespace toile {
namespace {

/// Width of the smoothing of normals, mm, so that folds do not count; largest number of rounds.
constexpr double kSmoothing = 25;
constexpr int kMaxSmoothingRounds = 400;
/// Cost per length along the silhouette; 1 more where the cloth faces ahead or back.
constexpr double kSilhouette = 0.15;

/// Number of height bands in which the width is measured; quantile that counts as the widest.
constexpr int kBands = 60;
constexpr double kWidest = 0.995;
/// Cost of a distance from the widest place by the whole width; cost of facing ahead or back.
constexpr double kOffWidest = 20, kAheadOnEnvelope = 0.2;

/// Smoothed normals of the vertices; shorter than 1 where the cloth turns sharply.
Points3 smoothNormals(const SurfaceLinks& links, double usualEdge, const Progress& progress) {
    const MeshArrays& mesh = links.mesh();
    const Edges& edges = links.table().edges;
    Points3 normals = Points3::Zero(mesh.V.rows(), 3);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3d normal = doubleAreaNormal(mesh, f);
        for (int k = 0; k < 3; ++k) {
            normals.row(mesh.F(f, k)) += normal;
        }
    }
    Eigen::VectorXd degree = Eigen::VectorXd::Ones(mesh.V.rows());
    for (Eigen::Index e = 0; e < edges.rows(); ++e) {
        degree[edges(e, 0)] += 1;
        degree[edges(e, 1)] += 1;
    }
    const double wide = kSmoothing / std::max(usualEdge, kSmoothing / kMaxSmoothingRounds);
    const int rounds = std::clamp(static_cast<int>(wide * wide), 1, kMaxSmoothingRounds);
    for (int round = 0; round < rounds && !progress.isCancelled(); ++round) {
        normals.rowwise().normalize();
        Points3 sum = normals;
        for (Eigen::Index e = 0; e < edges.rows(); ++e) {
            sum.row(edges(e, 0)) += normals.row(edges(e, 1));
            sum.row(edges(e, 1)) += normals.row(edges(e, 0));
        }
        normals = degree.cwiseInverse().asDiagonal() * sum;
    }
    normals.rowwise().normalize();
    return normals;
}

}  // namespace

BodyWays::BodyWays(const SurfaceLinks& links, const GarmentBody& body, const Progress& progress)
    : links_(links),
      body_(body),
      progress_(progress),
      lengths_(edgeLengths(links.mesh(), links.table().edges)) {
    const Eigen::VectorXd facing =
        smoothNormals(links, medianOf(lengths_), progress) * body.forward;
    facing_.assign(facing.data(), facing.data() + facing.size());
    silhouette_ = costs([this](int v) { return kSilhouette + std::abs(facing_[v]); });
}

double BodyWays::length(const std::vector<int>& way) const {
    double sum = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        sum += (at(way[k]) - at(way[k - 1])).norm();
    }
    return sum;
}

std::vector<double> BodyWays::costs(const std::function<double(int)>& factorAt) const {
    const Edges& edges = links_.table().edges;
    std::vector<double> factor(static_cast<std::size_t>(links_.vertexCount()));
    for (int v = 0; v < links_.vertexCount(); ++v) {
        factor[v] = factorAt(v);
    }
    std::vector<double> all(lengths_);
    for (std::size_t e = 0; e < all.size(); ++e) {
        const auto row = static_cast<Eigen::Index>(e);
        all[e] *= (factor[edges(row, 0)] + factor[edges(row, 1)]) / 2;
    }
    return all;
}

std::vector<double> BodyWays::envelope() const {
    const int count = links_.vertexCount();
    double least = height(0), most = least;
    for (int v = 0; v < count; ++v) {
        least = std::min(least, height(v));
        most = std::max(most, height(v));
    }
    const auto bandOf = [&](int v) {
        const double share = (height(v) - least) / std::max(most - least, 1e-9);
        return std::min(static_cast<int>(share * kBands), kBands - 1);
    };
    std::vector<std::vector<double>> widths(kBands);
    for (int v = 0; v < count; ++v) {
        widths[bandOf(v)].push_back(std::abs(across(v)));
    }
    std::vector<double> widest(kBands, 1);
    for (int band = 0; band < kBands; ++band) {
        widest[band] = std::max(quantileOf(std::move(widths[band]), kWidest), 1.0);
    }
    return costs([&](int v) {
        const double off = 1 - std::min(std::abs(across(v)) / widest[bandOf(v)], 1.0);
        return kSilhouette + kOffWidest * off * off + kAheadOnEnvelope * std::abs(facing_[v]);
    });
}

std::vector<int> BodyWays::cheapest(const std::vector<double>& costs, const std::vector<int>& from,
                                    const std::vector<int>& to) const {
    if (from.empty() || to.empty()) {
        return {};
    }
    const Edges& edges = links_.table().edges;
    const auto forest =
        geometry::shortestForest(edges, links_.vertexCount(), costs, {from}, -1, progress_);
    const int end =
        *std::ranges::min_element(to, {}, [&forest](int v) { return forest.distance[v]; });
    return std::isfinite(forest.distance[end]) ? forest.pathTo(end, edges) : std::vector<int>{};
}

geometry::ShortestForest BodyWays::waysFrom(int vertex, const std::vector<double>& costs) const {
    return geometry::shortestForest(links_.table().edges, links_.vertexCount(), costs, {{vertex}},
                                    -1, progress_);
}

}  // namespace toile
