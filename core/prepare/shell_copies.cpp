// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_copies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace toile::shell {
namespace {

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

}  // namespace

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

}  // namespace toile::shell
