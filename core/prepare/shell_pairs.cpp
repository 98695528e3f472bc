// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/prepare/shell_copies.h"
#include "core/prepare/shell_rays.h"

namespace toile::shell {
namespace {

/// No cloth is thicker, quilted down included.
constexpr double kThickest = 30;
/// Nor is it thicker than this share of the root of the area: a small model in the wrong unit.
constexpr double kThickestOfSize = 0.05;
/// A few triangles say how the surfaces are turned, more of them whether it is a shell: the shares
/// of their area that must face another surface, the second within two spans of distances.
constexpr int kFirstSample = 200, kSample = 2000;
constexpr double kFirstShare = 0.3, kLeastShare = 0.5;
/// How much farther, or nearer, than nearly all of the sample a surface may be.
constexpr double kBeyondSample = 3;
/// Slant of a seed that is believed: 18 degrees.
constexpr double kBelievedSlant = 0.05;
constexpr int kRaysPerCancelCheck = 1 << 10;

/// What a sample of triangles meets.
struct Sample {
    double area = 0, all = 0;
    std::vector<int> triangles;
    std::vector<Meeting> met;
    std::vector<std::pair<double, double>> distances;  ///< with areas
};

Sample sampleOf(const Surface& surface, const Rays& rays, Facing facing, double farthest,
                int size) {
    Sample sample;
    const int count = static_cast<int>(surface.mesh.F.rows());
    const int step = std::max(1, count / size);
    for (int t = 0; t < count; t += step) {
        sample.all += surface.area[t];
        const Meeting met = rays.opposite(t, facing, farthest);
        if (met.triangle >= 0) {
            sample.area += surface.area[t];
            sample.triangles.push_back(t);
            sample.met.push_back(met);
            sample.distances.emplace_back(met.way.norm(), surface.area[t]);
        }
    }
    return sample;
}

/// The seeds of a sample, best first.
std::vector<Copies::Seed> seedsOf(const Copies& copies, const Sample& sample) {
    std::vector<Copies::Seed> seeds;
    for (std::size_t i = 0; i < sample.triangles.size(); ++i) {
        const Copies::Seed seed = copies.seedOf(sample.triangles[i], sample.met[i]);
        if (seed.slant <= kBelievedSlant) {
            seeds.push_back(seed);
        }
    }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [](const auto& a, const auto& b) { return a.slant < b.slant; });
    return seeds;
}

/// From a triangle's corners to their partners, on average.
Eigen::Vector3d wayToPartners(const MeshArrays& mesh, int triangle,
                              const std::vector<int>& partner) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int v : mesh.F.row(triangle)) {
        sum += mesh.V.row(partner[v]) - mesh.V.row(v);
    }
    return sum.transpose() / 3;
}

}  // namespace

Surface surfaceWith(MeshArrays mesh, std::vector<int> face) {
    Surface surface{std::move(mesh), std::move(face), {}, {}};
    const Eigen::Index count = surface.mesh.F.rows();
    surface.normal = Points3::Zero(count, 3);
    surface.area.resize(count);
    for (Eigen::Index t = 0; t < count; ++t) {
        const Eigen::Vector3d normal = doubleAreaNormal(surface.mesh, t);
        const double length = normal.norm();
        const bool hasArea = length > 0 && std::isfinite(length);
        surface.area[t] = hasArea ? length / 2 : 0;
        if (hasArea) {
            surface.normal.row(t) = normal.transpose() / length;
        }
    }
    return surface;
}

double shareInTwoSpans(std::vector<std::pair<double, double>>& valueAndWeight) {
    auto& values = valueAndWeight;
    std::sort(values.begin(), values.end());
    const std::size_t count = values.size();
    // From the largest value down: the weight of the span that begins there, and the best of all
    // spans that begin there or later.
    std::vector<double> upTo(count + 1, 0), bestFrom(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        upTo[i + 1] = upTo[i] + values[i].second;
    }
    double best = 0;
    std::size_t end = count;
    for (std::size_t i = count; i-- > 0;) {
        while (end > i && values[end - 1].first > kSameThickness * values[i].first) {
            --end;
        }
        const double span = upTo[end] - upTo[i];
        best = std::max(best, span + bestFrom[end]);
        bestFrom[i] = std::max(bestFrom[i + 1], span);
    }
    return count > 0 ? best / upTo[count] : 0;
}

std::optional<Pairs> findPairs(const Surface& surface, const Progress& progress) {
    const MeshArrays& mesh = surface.mesh;
    const Rays rays(surface);
    const double size = std::sqrt(surface.area.sum());
    double farthest = std::min(kThickest, kThickestOfSize * size);
    Sample first;
    Facing facing = Facing::Apart;
    for (int i = 0; i < kFacings; ++i) {
        Sample other = sampleOf(surface, rays, static_cast<Facing>(i), farthest, kFirstSample);
        if (other.area > first.area) {
            first = std::move(other);
            facing = static_cast<Facing>(i);
        }
    }
    if (!(first.area > 0 && first.area >= kFirstShare * first.all) || progress.isCancelled()) {
        return std::nullopt;
    }
    Sample sample = sampleOf(surface, rays, facing, farthest, kSample);
    if (!(sample.area > 0 &&
          shareInTwoSpans(sample.distances) * sample.area >= kLeastShare * sample.all)) {
        return std::nullopt;
    }
    const std::size_t most = sample.distances.size() * 9 / 10;
    farthest = std::min(farthest, kBeyondSample * sample.distances[most].first);
    const double nearest = sample.distances[sample.distances.size() / 10].first / kBeyondSample;

    Copies copies(surface, facing, farthest);
    for (const Copies::Seed& seed : seedsOf(copies, sample)) {
        copies.follow(seed);
    }
    const std::vector<int>& partner = copies.partners();
    const int count = static_cast<int>(mesh.F.rows());
    Pairs pairs;
    pairs.opposite.assign(static_cast<std::size_t>(count), -1);
    pairs.isRim.assign(static_cast<std::size_t>(count), 0);
    pairs.thickness.assign(static_cast<std::size_t>(count), 0);
    pairs.across = Points3::Zero(count, 3);
    for (int t = 0; t < count; ++t) {
        if (t % kRaysPerCancelCheck == 0 && progress.isCancelled()) {
            return std::nullopt;
        }
        if (copies.isPaired(t) || copies.isRim(t)) {
            continue;
        }
        const Meeting met = rays.opposite(t, facing, farthest);
        const Copies::Seed seed = copies.seedOf(t, met);
        if (seed.slant <= kBelievedSlant) {
            copies.follow(seed);
        }
        if (met.triangle >= 0 && met.way.norm() >= nearest) {
            pairs.opposite[t] = met.triangle;
            pairs.across.row(t) = met.way;
        }
    }
    for (int t = 0; t < count; ++t) {
        if (copies.isPaired(t)) {
            pairs.opposite[t] = copies.mateOf(t);
            pairs.across.row(t) = wayToPartners(mesh, t, partner);
        } else if (copies.isRim(t)) {
            pairs.isRim[t] = 1;
            pairs.opposite[t] = -1;
        }
        if (pairs.opposite[t] >= 0) {
            pairs.thickness[t] = std::abs(pairs.across.row(t).dot(surface.normal.row(t)));
        }
    }
    pairs.partner = partner;
    return pairs;
}

}  // namespace toile::shell
