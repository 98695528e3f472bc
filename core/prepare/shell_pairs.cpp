// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/prepare/shell_copies.h"
#include "core/prepare/shell_rays.h"

namespace toile::shell {
namespace {

/// No cloth is thicker, including quilted down.
constexpr double kThickest = 30;
/// Maximum relative to the root of the area: for a small model in the wrong unit.
constexpr double kThickestOfSize = 0.05;
/// The first sample shows the surfaces' orientation, the second whether it is a shell: minimum
/// shares of their area that face another surface, the second within two spans of distances.
constexpr int kFirstSample = 200, kSample = 2000;
constexpr double kFirstShare = 0.3, kMinPairShare = 0.5;
/// How many times farther, or closer, than nearly all of the sample a surface may be.
constexpr double kBeyondSample = 3;
/// Slant up to which a seed is accepted: 18 degrees.
constexpr double kBelievedSlant = 0.05;
constexpr int kRaysPerCancelCheck = 1 << 10;

/// The hits of a sample of triangles.
struct Sample {
    double area = 0, all = 0;
    std::vector<int> triangles;
    std::vector<Meeting> met;
    std::vector<std::pair<double, double>> distances;  ///< with areas
};

Sample sampleOf(const Surface& surface, const Rays& rays, Facing facing, double farthest, int size,
                const Progress& progress) {
    Sample sample;
    const int count = static_cast<int>(surface.mesh.F.rows());
    const int step = std::max(1, count / size);
    for (int t = 0; t < count && !progress.isCancelled(); t += step) {
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

/// Mean vector from a triangle's corners to their partners: a corner within a polygon, at a welded
/// slit, has none.
Eigen::Vector3d wayToPartners(const MeshArrays& mesh, int triangle,
                              const std::vector<int>& partner) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    int count = 0;
    for (const int v : mesh.F.row(triangle)) {
        if (partner[v] >= 0) {
            sum += mesh.V.row(partner[v]) - mesh.V.row(v);
            ++count;
        }
    }
    return sum.transpose() / std::max(count, 1);
}

/// The relative position of two surfaces.
struct Reach {
    Facing facing = Facing::Apart;
    double nearest = 0, farthest = 0;  ///< search distances, mm
    Sample sample;
};

/// Nothing if a sample shows that it is not a shell.
std::optional<Reach> reachOf(const Surface& surface, const Rays& rays, const Progress& progress) {
    Reach reach;
    reach.farthest = std::min(kThickest, kThickestOfSize * std::sqrt(surface.area.sum()));
    double area = 0, all = 0;
    for (const Facing facing : {Facing::Apart, Facing::Towards, Facing::Alike}) {
        const Sample first =
            sampleOf(surface, rays, facing, reach.farthest, kFirstSample, progress);
        all = first.all;
        if (first.area > area) {
            area = first.area;
            reach.facing = facing;
        }
    }
    if (area == 0 || area < kFirstShare * all || progress.isCancelled()) {
        return std::nullopt;
    }
    Sample& sample = reach.sample;
    sample = sampleOf(surface, rays, reach.facing, reach.farthest, kSample, progress);
    const double share = shareInTwoSpans(sample.distances);  // sorted by this call
    if (sample.area == 0 || share * sample.area < kMinPairShare * sample.all) {
        return std::nullopt;
    }
    const std::size_t count = sample.distances.size();
    reach.farthest =
        std::min(reach.farthest, kBeyondSample * sample.distances[count * 9 / 10].first);
    reach.nearest = sample.distances[count / 10].first / kBeyondSample;
    return reach;
}

/// If there are copies, they are the opposites, and polygons that connect them are rims.
void takeCopies(const Surface& surface, const Copies& copies, Pairs& pairs) {
    for (int t = 0; t < std::ssize(pairs.opposite); ++t) {
        if (copies.isPaired(t)) {
            pairs.opposite[t] = copies.mateOf(t);
            pairs.across.row(t) = wayToPartners(surface.mesh, t, pairs.partner);
        } else if (copies.isRim(t)) {
            pairs.isRim[t] = 1;
            pairs.opposite[t] = -1;
        }
        if (pairs.opposite[t] >= 0) {
            pairs.thickness[t] = std::abs(pairs.across.row(t).dot(surface.normal.row(t)));
        }
    }
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
    const Rays rays(surface);
    std::optional<Reach> reach = reachOf(surface, rays, progress);
    if (!reach) {
        return std::nullopt;
    }
    Copies copies(surface, reach->facing, reach->farthest);
    for (const Copies::Seed& seed : seedsOf(copies, reach->sample)) {
        copies.follow(seed);
    }
    const auto count = static_cast<std::size_t>(surface.mesh.F.rows());
    Pairs pairs{.partner = {},
                .opposite = std::vector(count, -1),
                .isRim = std::vector<char>(count, 0),
                .across = Points3::Zero(surface.mesh.F.rows(), 3),
                .thickness = std::vector(count, 0.0)};
    for (int t = 0; t < std::ssize(pairs.opposite); ++t) {
        if (t % kRaysPerCancelCheck == 0 && progress.isCancelled()) {
            return std::nullopt;
        }
        if (copies.isPaired(t) || copies.isRim(t)) {
            continue;
        }
        const Meeting met = rays.opposite(t, reach->facing, reach->farthest);
        const Copies::Seed seed = copies.seedOf(t, met);
        if (seed.slant <= kBelievedSlant) {
            copies.follow(seed);
        }
        if (met.triangle >= 0 && met.way.norm() >= reach->nearest) {
            pairs.opposite[t] = met.triangle;
            pairs.across.row(t) = met.way;
        }
    }
    pairs.partner = copies.partners();
    takeCopies(surface, copies, pairs);
    return pairs;
}

}  // namespace toile::shell
