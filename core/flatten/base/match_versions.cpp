// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/match_versions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "core/garment/piece.h"
#include "core/geometry/buckets.h"

namespace toile {
namespace {

/// A vertex farther outside of a triangle, in barycentric coordinates, is not part of it.
constexpr double kOutside = 0.01;
/// A face of the file divided into more triangles is not searched, because a polygon with thousands
/// of corners would take quadratic time.
constexpr std::size_t kMaxCandidates = 64;

bool sameArrays(const Piece& a, const Piece& b) {
    return a.mesh.F.rows() == b.mesh.F.rows() && a.mesh.V.rows() == b.mesh.V.rows() &&
           a.sourceVertex == b.sourceVertex && a.sourceFace == b.sourceFace &&
           (a.mesh.F.array() == b.mesh.F.array()).all();
}

int sourceOf(const std::vector<int>& sources, int index) {
    return sources.empty() ? index : sources[index];
}

/// Coordinates in the plane through the triangle; NaN if it has no area.
Eigen::RowVector3d barycentricIn(const MeshArrays& mesh, int face, const Eigen::RowVector3d& p) {
    const Eigen::RowVector3d a = mesh.V.row(mesh.F(face, 0));
    const Eigen::RowVector3d b = mesh.V.row(mesh.F(face, 1));
    const Eigen::RowVector3d c = mesh.V.row(mesh.F(face, 2));
    const Eigen::RowVector3d normal = (b - a).cross(c - a);
    const double doubled = normal.squaredNorm();
    const double ofB = (p - a).cross(c - a).dot(normal) / doubled;
    const double ofC = (b - a).cross(p - a).dot(normal) / doubled;
    return {1 - ofB - ofC, ofB, ofC};
}

class Matcher {
public:
    Matcher(const Piece& piece, const Piece& before)
        : piece_(piece), before_(before), rank_(ranksOf(piece)) {
        const int faces = static_cast<int>(before.mesh.F.rows());
        int most = -1;
        for (int f = 0; f < faces; ++f) {
            most = std::max(most, sourceOf(before.sourceFace, f));
        }
        faces_ = geometry::Buckets<>(most + 1, [&](auto add) {
            for (int f = 0; f < faces; ++f) {
                if (const int source = sourceOf(before.sourceFace, f); source >= 0) {
                    add(source, f);
                }
            }
        });
        match_.vertex.assign(static_cast<std::size_t>(piece.mesh.V.rows()), -1);
    }

    VersionMatch run() {
        // Whole triangles first: they decide on which side of a cut their corners lie.
        matchFaces(3);
        matchFaces(1);
        match_.complete = placeOthers();
        return std::move(match_);
    }

private:
    /// Per triangle: number of earlier triangles from the same face of the file.
    static std::vector<int> ranksOf(const Piece& piece) {
        std::vector<int> rank(static_cast<std::size_t>(piece.mesh.F.rows()), 0);
        std::vector<int> count;
        for (std::size_t f = 0; f < rank.size(); ++f) {
            const int source = sourceOf(piece.sourceFace, static_cast<int>(f));
            if (source < 0) {
                continue;
            }
            if (static_cast<std::size_t>(source) >= count.size()) {
                count.resize(static_cast<std::size_t>(source) + 1, 0);
            }
            rank[f] = count[source]++;
        }
        return rank;
    }

    /// The candidate of equal rank, -1 if there is none. Away from an edit it is the triangle
    /// itself.
    int likeliest(int face) const {
        const auto all = allCandidates(face);
        const auto rank = static_cast<std::size_t>(rank_[face]);
        return rank < all.size() ? all[rank] : -1;
    }

    /// Candidates to test besides the likeliest.
    std::span<const int> candidates(int face) const {
        const auto all = allCandidates(face);
        return all.size() <= kMaxCandidates ? all : std::span<const int>();
    }

    /// Triangles of the earlier version from the same face of the file.
    std::span<const int> allCandidates(int face) const {
        const int source = sourceOf(piece_.sourceFace, face);
        return source < 0 || source >= faces_.keyCount() ? std::span<const int>() : faces_[source];
    }

    bool same(int v, int w) const {
        const int source = sourceOf(piece_.sourceVertex, v);
        return source == sourceOf(before_.sourceVertex, w) &&
               (source >= 0 || piece_.mesh.V.row(v) == before_.mesh.V.row(w));
    }

    /// The corner of `other` that corresponds to corner k of `face`, or -1.
    int cornerOf(int face, int k, int other) const {
        for (int c = 0; c < 3; ++c) {
            if (same(piece_.mesh.F(face, k), before_.mesh.F(other, c))) {
                return before_.mesh.F(other, c);
            }
        }
        return -1;
    }

    bool hasOpenCorner(int face) const {
        return match_.vertex[piece_.mesh.F(face, 0)] < 0 ||
               match_.vertex[piece_.mesh.F(face, 1)] < 0 ||
               match_.vertex[piece_.mesh.F(face, 2)] < 0;
    }

    /// Matches triangles that share at least this many corners with an earlier one.
    void matchFaces(int least) {
        for (int f = 0; f < piece_.mesh.F.rows(); ++f) {
            if (!hasOpenCorner(f)) {
                continue;
            }
            int most = least - 1;
            Eigen::Vector3i best = Eigen::Vector3i::Constant(-1);
            const auto tryOn = [&](int other) {
                const Eigen::Vector3i corners(cornerOf(f, 0, other), cornerOf(f, 1, other),
                                              cornerOf(f, 2, other));
                const auto count = static_cast<int>((corners.array() >= 0).count());
                if (count > most) {
                    most = count;
                    best = corners;
                }
            };
            if (const int other = likeliest(f); other >= 0) {
                tryOn(other);
            }
            if (most < 3) {
                for (const int other : candidates(f)) {
                    tryOn(other);
                }
            }
            for (int k = 0; k < 3; ++k) {
                int& known = match_.vertex[piece_.mesh.F(f, k)];
                known = known < 0 ? best[k] : known;
            }
        }
    }

    /// Finds the triangles that contain new vertices. False if a vertex is in none.
    bool placeOthers() {
        std::vector<char> isPlaced(match_.vertex.size(), 0);
        std::size_t open = 0;
        for (const int v : match_.vertex) {
            open += v < 0 ? 1 : 0;
        }
        for (int f = 0; f < piece_.mesh.F.rows() && match_.placed.size() < open; ++f) {
            for (int k = 0; k < 3; ++k) {
                const int v = piece_.mesh.F(f, k);
                if (match_.vertex[v] >= 0 || isPlaced[v] != 0) {
                    continue;
                }
                VersionMatch::Placed best{v, -1, {}};
                double least = -kOutside;
                for (const int other : candidates(f)) {
                    const Eigen::RowVector3d at =
                        barycentricIn(before_.mesh, other, piece_.mesh.V.row(v));
                    if (at.minCoeff() > least) {
                        least = at.minCoeff();
                        best.face = other;
                        best.barycentric = at;
                    }
                }
                if (best.face >= 0) {
                    isPlaced[v] = 1;
                    match_.placed.push_back(best);
                }
            }
        }
        return match_.placed.size() == open;
    }

    const Piece& piece_;
    const Piece& before_;
    geometry::Buckets<> faces_;  ///< the earlier version's triangles by face of the file
    std::vector<int> rank_;      ///< of the piece's triangles
    VersionMatch match_;
};

using Place = std::array<double, 3>;

/// Vertices by position in space; -1 if several share a position.
std::map<Place, int> byPlace(const Piece& piece) {
    std::map<Place, int> vertexAt;
    for (int v = 0; v < piece.mesh.V.rows(); ++v) {
        const Place place{piece.mesh.V(v, 0), piece.mesh.V(v, 1), piece.mesh.V(v, 2)};
        if (const auto [known, isNew] = vertexAt.emplace(place, v); !isNew) {
            known->second = -1;
        }
    }
    return vertexAt;
}

/// For a file rewritten with other numbers: the match by position, if it finds most vertices, and
/// if few vertices are unchanged under their numbers. n log n then.
std::optional<VersionMatch> renumberedMatch(const Piece& piece, const Piece& before) {
    std::unordered_map<int, int> bySource;
    for (int v = 0; v < before.mesh.V.rows(); ++v) {
        bySource.emplace(sourceOf(before.sourceVertex, v), v);
    }
    const auto count = piece.mesh.V.rows();
    Eigen::Index stay = 0, known = 0;
    for (int v = 0; v < count; ++v) {
        const int source = sourceOf(piece.sourceVertex, v);
        const auto old = bySource.find(source);
        known += source >= 0 ? 1 : 0;
        stay += source >= 0 && old != bySource.end() &&
                before.mesh.V.row(old->second) == piece.mesh.V.row(v);
    }
    if (2 * stay >= known) {
        return std::nullopt;
    }
    VersionMatch match;
    match.vertex.assign(static_cast<std::size_t>(count), -1);
    const std::map<Place, int> then = byPlace(before);
    Eigen::Index found = 0;
    for (const auto& [place, vertex] : byPlace(piece)) {
        const auto old = then.find(place);
        if (vertex >= 0 && old != then.end() && old->second >= 0) {
            match.vertex[static_cast<std::size_t>(vertex)] = old->second;
            ++found;
        }
    }
    match.complete = found == count;
    return 2 * found > count ? std::optional(std::move(match)) : std::nullopt;
}

}  // namespace

VersionMatch matchVersions(const Piece& piece, const Piece& before) {
    if (sameArrays(piece, before)) {
        VersionMatch match;
        match.vertex.resize(static_cast<std::size_t>(piece.mesh.V.rows()));
        std::iota(match.vertex.begin(), match.vertex.end(), 0);
        match.complete = true;
        return match;
    }
    if (piece.file != before.file || piece.sourceFace.empty() != before.sourceFace.empty()) {
        VersionMatch nothing;
        nothing.vertex.assign(static_cast<std::size_t>(piece.mesh.V.rows()), -1);
        return nothing;
    }
    if (auto match = renumberedMatch(piece, before)) {
        return *std::move(match);
    }
    return Matcher(piece, before).run();
}

std::optional<Points2> carriedOver(const VersionMatch& match, const Piece& before,
                                   const Points2& Q) {
    if (!match.complete) {
        return std::nullopt;
    }
    Points2 carried(static_cast<Eigen::Index>(match.vertex.size()), 2);
    for (std::size_t v = 0; v < match.vertex.size(); ++v) {
        if (match.vertex[v] >= 0) {
            carried.row(static_cast<Eigen::Index>(v)) = Q.row(match.vertex[v]);
        }
    }
    for (const auto& [vertex, face, barycentric] : match.placed) {
        carried.row(vertex) = barycentric[0] * Q.row(before.mesh.F(face, 0)) +
                              barycentric[1] * Q.row(before.mesh.F(face, 1)) +
                              barycentric[2] * Q.row(before.mesh.F(face, 2));
    }
    return carried;
}

}  // namespace toile
