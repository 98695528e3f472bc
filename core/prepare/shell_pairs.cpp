// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/prepare/shell_rays.h"

namespace toile::shell {
namespace {

/// Follows two surfaces, one a copy of the other, polygon by polygon, as exporters create a
/// thickness: from one pair of polygons over their sides to the next, as long as they match.
class Copies {
public:
    Copies(const Surface& surface, Facing facing, double farthest);

    /// How two polygons match.
    struct Seed {
        double slant = 2;  ///< 1 - cosine between the normal and the way between corners
        int polygon = -1, other = -1;
        int shift = 0;  ///< index of the other's corner that matches the first corner
    };
    /// A seed with a slant of 2 if the polygons of a triangle and the one that it met do not match.
    Seed seedOf(int triangle, const Meeting& met) const;

    /// Accepts a seed and all pairs that follow from it, if none of them is taken.
    void follow(const Seed& seed);

    /// Whether a triangle's polygon has a copy.
    bool isPaired(int triangle) const { return mate_[polygon_[triangle]] >= 0; }
    /// Whether a triangle's polygon connects a vertex with its copy.
    bool isRim(int triangle) const;
    /// A triangle of the copy of a triangle's polygon. Precondition: isPaired
    int mateOf(int triangle) const { return firstTriangle_[mate_[polygon_[triangle]]]; }

    const std::vector<int>& partners() const { return partner_; }

private:
    struct SidePair {
        int side, other;
    };

    void addPolygon(int first, int last);
    void linkSides();
    int corners(int polygon) const { return start_[polygon + 1] - start_[polygon]; }
    int cornerAt(int polygon, int k) const {
        return corner_[start_[polygon] + k % corners(polygon)];
    }
    int mirrored(int other, int shift, int k) const;
    bool pairUp(const Seed& seed, double distance);
    double distance(int v, int w) const {
        return (surface_.mesh.V.row(v) - surface_.mesh.V.row(w)).norm();
    }

    const Surface& surface_;
    Facing facing_;
    double farthest_;
    std::vector<int> polygon_;        ///< per triangle
    std::vector<int> firstTriangle_;  ///< per polygon
    std::vector<int> start_{0};       ///< per polygon: of its corners; one more for the end
    std::vector<int> corner_;         ///< vertices
    std::vector<int> owner_;          ///< per corner: the polygon; side s begins at corner s
    std::vector<int> across_;         ///< per side: the only other one there, in reverse, or -1
    std::vector<int> mate_;           ///< per polygon, or -1
    std::vector<int> partner_;        ///< per vertex, or -1
    std::vector<SidePair> open_;
};

/// How many times farther apart, or closer, a pair of corners may be than its neighbours: a corner
/// paired with its copy's neighbour is farther away if triangles are larger than the thickness.
constexpr double kDistanceRatio = 2;
/// Minimum mean cosine between the direction to the copy and the normal: in rows of a rim that
/// direction lies in the surface.
constexpr double kThrough = 0.25;
/// Polygons with more corners are not cloth; matching two of them is quadratic.
constexpr int kMaxFaceCorners = 64;

std::uint64_t keyOf(int a, int b) {
    return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
}

Copies::Copies(const Surface& surface, Facing facing, double farthest)
    : surface_(surface), facing_(facing), farthest_(farthest) {
    const int triangleCount = static_cast<int>(surface.mesh.F.rows());
    polygon_.resize(static_cast<std::size_t>(triangleCount));
    for (int first = 0; first < triangleCount;) {
        int last = first + 1;
        while (last < triangleCount && surface.face[last] == surface.face[first]) {
            ++last;
        }
        addPolygon(first, last);
        first = last;
    }
    linkSides();
    mate_.assign(firstTriangle_.size(), -1);
    partner_.assign(static_cast<std::size_t>(surface.mesh.V.rows()), -1);
}

/// The outline of triangles: their sides that no other of them shares.
void Copies::addPolygon(int first, int last) {
    const Triangles& F = surface_.mesh.F;
    const int polygon = static_cast<int>(firstTriangle_.size());
    firstTriangle_.push_back(first);
    std::fill(polygon_.begin() + first, polygon_.begin() + last, polygon);
    std::vector<std::uint64_t> sides;
    for (int side = 3 * first; side < 3 * last; ++side) {
        sides.push_back(keyOf(tailOf(F, side), headOf(F, side)));
    }
    if (last - first > 1) {
        std::sort(sides.begin(), sides.end());
        std::vector<std::uint64_t> outline;
        for (const std::uint64_t side : sides) {
            const std::uint64_t back = side << 32 | side >> 32;
            if (!std::binary_search(sides.begin(), sides.end(), back)) {
                outline.push_back(side);
            }
        }
        sides = std::move(outline);
    }
    // In their order along the outline; an outline that does not close is not a polygon.
    std::vector<int> loop;
    for (std::size_t i = 0, at = 0; i < sides.size(); ++i) {
        loop.push_back(static_cast<int>(sides[at] >> 32));
        const std::uint64_t next = sides[at] << 32;
        const auto after = last - first > 1
                               ? std::lower_bound(sides.begin(), sides.end(), next)
                               : sides.begin() + static_cast<std::ptrdiff_t>((at + 1) % 3);
        if (after == sides.end() || (*after >> 32) != (next >> 32)) {
            loop.clear();
            break;
        }
        at = static_cast<std::size_t>(after - sides.begin());
        if (at == 0 && i + 1 < sides.size()) {
            loop.clear();  // more than one loop
            break;
        }
    }
    corner_.insert(corner_.end(), loop.begin(), loop.end());
    owner_.resize(corner_.size(), polygon);
    start_.push_back(static_cast<int>(corner_.size()));
}

void Copies::linkSides() {
    std::vector<std::pair<std::uint64_t, int>> sides;
    sides.reserve(corner_.size());
    const auto headOfSide = [this](int side) {
        const int polygon = owner_[side];
        return cornerAt(polygon, side - start_[polygon] + 1);
    };
    for (int side = 0; side < static_cast<int>(corner_.size()); ++side) {
        const int tail = corner_[side], head = headOfSide(side);
        sides.emplace_back(keyOf(std::min(tail, head), std::max(tail, head)), side);
    }
    std::sort(sides.begin(), sides.end());
    across_.assign(corner_.size(), -1);
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].first == sides[i].first) {
            ++end;
        }
        const int a = sides[i].second, b = sides[end - 1].second;
        if (end - i == 2 && corner_[a] != corner_[b]) {
            across_[a] = b;
            across_[b] = a;
        }
        i = end;
    }
}

/// The corner of the other polygon that matches corner k.
int Copies::mirrored(int other, int shift, int k) const {
    const int count = corners(other);
    return cornerAt(other, facing_ == Facing::Alike ? shift + k : shift + count - k % count);
}

Copies::Seed Copies::seedOf(int triangle, const Meeting& met) const {
    Seed best;
    if (met.triangle < 0) {
        return best;
    }
    const int polygon = polygon_[triangle], other = polygon_[met.triangle];
    const int count = corners(polygon);
    if (count < 3 || count > kMaxFaceCorners || corners(other) != count) {
        return best;
    }
    const Eigen::Vector3d direction = met.way.normalized();
    for (int shift = 0; shift < count; ++shift) {
        double slant = 0;
        for (int k = 0; k < count; ++k) {
            const Eigen::Vector3d way = surface_.mesh.V.row(mirrored(other, shift, k)) -
                                        surface_.mesh.V.row(cornerAt(polygon, k));
            slant = std::max(slant, 1 - way.normalized().dot(direction));
        }
        if (slant < best.slant) {
            best = {slant, polygon, other, shift};
        }
    }
    return best;
}

/// Pairs the corners of two polygons if possible.
bool Copies::pairUp(const Seed& seed, double reference) {
    const int count = corners(seed.polygon);
    if (seed.polygon == seed.other || mate_[seed.polygon] >= 0 || mate_[seed.other] >= 0 ||
        count != corners(seed.other)) {
        return false;
    }
    const Eigen::RowVector3d normal = surface_.normal.row(firstTriangle_[seed.polygon]);
    double through = 0;
    for (int k = 0; k < count; ++k) {
        const int v = cornerAt(seed.polygon, k), w = mirrored(seed.other, seed.shift, k);
        const bool isSame = partner_[v] == w && partner_[w] == v;
        if (v == w || (!isSame && (partner_[v] >= 0 || partner_[w] >= 0))) {
            return false;
        }
        const double apart = distance(v, w);
        through += normal.dot(surface_.mesh.V.row(w) - surface_.mesh.V.row(v)) / apart;
        if (apart > farthest_ || apart > kDistanceRatio * reference ||
            apart * kDistanceRatio < reference) {
            return false;
        }
    }
    if (std::abs(through) < kThrough * count) {
        return false;
    }
    for (int k = 0; k < count; ++k) {
        const int v = cornerAt(seed.polygon, k), w = mirrored(seed.other, seed.shift, k);
        partner_[v] = w;
        partner_[w] = v;
    }
    mate_[seed.polygon] = seed.other;
    mate_[seed.other] = seed.polygon;
    for (int k = 0; k < count; ++k) {
        // If reversed, the side runs from the next corner's copy, else from this one's.
        const int from = facing_ == Facing::Alike ? seed.shift + k : seed.shift + 2 * count - k - 1;
        open_.push_back({start_[seed.polygon] + k, start_[seed.other] + from % count});
    }
    return true;
}

bool Copies::isRim(int triangle) const {
    const int polygon = polygon_[triangle];
    for (int k = 0; k < corners(polygon); ++k) {
        if (partner_[cornerAt(polygon, k)] == cornerAt(polygon, k + 1)) {
            return true;
        }
    }
    return false;
}

void Copies::follow(const Seed& seed) {
    const double apart = distance(cornerAt(seed.polygon, 0), mirrored(seed.other, seed.shift, 0));
    pairUp(seed, apart);
    while (!open_.empty()) {
        const auto [side, other] = open_.back();
        open_.pop_back();
        const int beyond = across_[side], otherBeyond = across_[other];
        if (beyond < 0 || otherBeyond < 0) {
            continue;
        }
        // In the next polygon, a side begins where it ended here.
        Seed next{0, owner_[beyond], owner_[otherBeyond]};
        const int k = beyond - start_[next.polygon], count = corners(next.polygon);
        const int j = otherBeyond - start_[next.other];
        if (count != corners(next.other)) {
            continue;
        }
        next.shift = facing_ == Facing::Alike ? (j - k + count) % count : (j + 1 + k) % count;
        const int v = corner_[side];
        pairUp(next, distance(v, partner_[v]));
    }
}

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
