// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/intrinsic_delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/buckets.h"
#include "core/geometry/segment.h"
#include "core/mesh/cotangents.h"

namespace toile {
namespace {

/// Rounding error of a layout in sin(alpha + beta): relative to the cotangents it is larger for
/// flatter triangles. Twice this value separates an edge from the other diagonal.
constexpr double kSineTolerance = 16 * std::numeric_limits<double>::epsilon();
/// A weight whose negative value is smaller than this part of its summands (and of one) counts as
/// zero: the four corners are cocircular within the rounding of their coordinates.
constexpr double kWeightTolerance = 1e-12;

/// A triangulated surface without an embedding: every triangle lies flat in its own plane. Edges
/// can be flipped within the surface, after which two triangles may share two edges and an edge may
/// be a loop. Half-edge 3 f + k starts as the one from corner k of face f to corner k + 1; a flip
/// keeps the indices and changes the edges that they refer to.
class FlippableSurface {
public:
    /// @param mesh  a manifold, oriented surface without degenerate triangles  Cost: linear.
    FlippableSurface(const MeshArrays& mesh, const EdgeTable& table)
        : halfedges_(static_cast<std::size_t>(mesh.F.size())) {
        for (int f = 0; f < mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                Halfedge& halfedge = halfedges_[3 * f + k];
                halfedge.next = 3 * f + (k + 1) % 3;
                halfedge.origin = mesh.F(f, k);
                const std::span<const int> uses = table.usesOf(table.faceEdges(f, k));
                halfedge.twin = uses.size() == 2 ? uses[0] + uses[1] - (3 * f + k) : -1;
            }
            layOut(mesh, f);
        }
    }

    int halfedgeCount() const { return static_cast<int>(halfedges_.size()); }
    int twin(int h) const { return halfedges_[h].twin; }  ///< -1 on the boundary
    int origin(int h) const { return halfedges_[h].origin; }
    int target(int h) const { return halfedges_[next(h)].origin; }

    /// Cotangent of the angle opposite to a half-edge in its triangle. Finite.
    double oppositeCotangent(int h) const {
        const Eigen::Vector2d& a = halfedges_[next(h)].vector;
        const Eigen::Vector2d& b = halfedges_[previous(h)].vector;
        return -a.dot(b) / geometry::cross(a, b);
    }

    /// True if the angles opposite to an interior edge sum to more than pi by more than rounding,
    /// so that neither of a square's two diagonals is flipped.
    bool wantsFlip(int h) const {
        const int t = twin(h);
        if (t < 0) {
            return false;
        }
        const Eigen::Vector2d& a = halfedges_[next(h)].vector;
        const Eigen::Vector2d& b = halfedges_[previous(h)].vector;
        const Eigen::Vector2d& c = halfedges_[next(t)].vector;
        const Eigen::Vector2d& d = halfedges_[previous(t)].vector;
        // The sine of alpha + beta times the four lengths, and cot alpha + cot beta times both
        // areas.
        const double firstArea = geometry::cross(a, b);
        const double secondArea = geometry::cross(c, d);
        const double first = -a.dot(b) * secondArea;
        const double second = -c.dot(d) * firstArea;
        const double sum = first + second;
        return sum < -kWeightTolerance *
                         (std::abs(first) + std::abs(second) + firstArea * secondArea) &&
               sum * sum > kSineTolerance * kSineTolerance * a.squaredNorm() * b.squaredNorm() *
                               c.squaredNorm() * d.squaredNorm();
    }

    /// Replaces an edge by the other diagonal of its two triangles, laid out in a plane.
    /// @return false, without a change, if that would turn a triangle over
    bool flip(int h) {
        const int t = twin(h);
        const int afterH = next(h);
        const int beforeH = previous(h);
        const int afterT = next(t);
        const int beforeT = previous(t);
        if (t == afterH || t == beforeH) {
            return false;  // a triangle folded around a vertex; its edge is the only one at the tip
        }
        // Rotate the twin's triangle until both half-edges coincide: multiply by the unit complex
        // number -vector(h) / vector(t), scaled by the other's length.
        const Eigen::Vector2d& u = halfedges_[h].vector;
        const Eigen::Vector2d& v = halfedges_[t].vector;
        const Eigen::Vector2d turn = Eigen::Vector2d(-u.dot(v), geometry::cross(u, v)).normalized();
        const auto turned = [&turn](const Eigen::Vector2d& w) {
            return Eigen::Vector2d(turn.x() * w.x() - turn.y() * w.y(),
                                   turn.y() * w.x() + turn.x() * w.y());
        };
        const Eigen::Vector2d newAfterT = turned(halfedges_[afterT].vector);
        const Eigen::Vector2d newBeforeT = turned(halfedges_[beforeT].vector);
        if (!(geometry::cross(halfedges_[beforeH].vector, newAfterT) > 0 &&
              geometry::cross(newBeforeT, halfedges_[afterH].vector) > 0)) {
            return false;
        }
        halfedges_[afterT].vector = newAfterT;
        halfedges_[beforeT].vector = newBeforeT;
        // h ran from a to b with c on its left, the twin has d on its left; now h runs from d to c.
        halfedges_[h].vector = -(halfedges_[beforeH].vector + newAfterT);
        halfedges_[t].vector = -halfedges_[h].vector;
        halfedges_[h].origin = halfedges_[beforeT].origin;
        halfedges_[t].origin = halfedges_[beforeH].origin;
        const auto link = [this](int a, int b, int c) {
            halfedges_[a].next = b;
            halfedges_[b].next = c;
            halfedges_[c].next = a;
        };
        link(h, beforeH, afterT);
        link(t, beforeT, afterH);
        return true;
    }

    /// The other four sides of the two triangles at an interior edge.
    std::array<int, 4> sidesAround(int h) const {
        const int t = twin(h);
        return {next(h), previous(h), next(t), previous(t)};
    }

private:
    struct Halfedge {
        Eigen::Vector2d vector;  ///< in its triangle's plane; the three of a triangle sum to zero
        int next;
        int twin;
        int origin;
    };

    int next(int h) const { return halfedges_[h].next; }
    int previous(int h) const { return next(next(h)); }
    /// From the longest and the shortest side, so that the third is long too: computed as the
    /// difference of two long sides, a short side would lose digits.
    void layOut(const MeshArrays& mesh, int face) {
        std::array<Eigen::Vector3d, 3> side;
        std::array<int, 3> byLength{0, 1, 2};
        for (int k = 0; k < 3; ++k) {
            side[k] = mesh.V.row(mesh.F(face, (k + 1) % 3)) - mesh.V.row(mesh.F(face, k));
        }
        std::ranges::sort(byLength, {},
                          [&side](int k) { return std::pair(side[k].squaredNorm(), k); });
        const auto [shortest, middle, longest] = byLength;
        const double length = side[longest].norm();
        // Anti-clockwise: the side after the longest one turns left, the one before it comes from
        // there.
        const double turn = shortest == (longest + 1) % 3 ? 1 : -1;
        const Eigen::Vector2d base(length, 0);
        const Eigen::Vector2d other(side[shortest].dot(side[longest]) / length,
                                    turn * side[longest].cross(side[shortest]).norm() / length);
        halfedges_[3 * face + longest].vector = base;
        halfedges_[3 * face + shortest].vector = other;
        halfedges_[3 * face + middle].vector = -(base + other);
    }

    std::vector<Halfedge> halfedges_;
};

/// Flips between two checks of `Progress::isCancelled`; a power of two.
constexpr int kFlipsPerCancelCheck = 1 << 16;

/// An edge of the new triangulation, stored in the bucket of its smaller vertex.
struct Link {
    int larger;
    int halfedge;  ///< the larger of its two half-edges
};

/// A negative weight is rounded to zero if the edge is not to be flipped.
double weightOf(const FlippableSurface& surface, int h) {
    const int twin = surface.twin(h);
    if (twin < 0) {
        return 0.5 * surface.oppositeCotangent(h);
    }
    const double weight = 0.5 * (surface.oppositeCotangent(h) + surface.oppositeCotangent(twin));
    return weight < 0 && !surface.wantsFlip(h) ? 0 : weight;
}

/// Each edge once, sorted, parallel ones summed, in linear time as in `buildEdgeTable`.
WeightedEdges collect(const FlippableSurface& surface, int vertexCount) {
    geometry::Buckets<Link> links(vertexCount, [&surface](auto add) {
        for (int h = 0; h < surface.halfedgeCount(); ++h) {
            const auto [a, b] = std::minmax({surface.origin(h), surface.target(h)});
            if (h > surface.twin(h) && a != b) {
                add(a, Link{b, h});
            }
        }
    });
    std::vector<int> ends;
    std::vector<double> weights;
    ends.reserve(2 * links.items().size());
    weights.reserve(links.items().size());
    for (int v = 0; v < vertexCount; ++v) {
        // Stable, so that parallel edges are summed in the same order everywhere.
        std::ranges::stable_sort(links[v], {}, &Link::larger);
        int last = -1;
        for (const auto& [larger, halfedge] : links[v]) {
            const double weight = weightOf(surface, halfedge);
            if (std::exchange(last, larger) == larger) {
                weights.back() += weight;
                continue;
            }
            ends.insert(ends.end(), {v, larger});
            weights.push_back(weight);
        }
    }
    const auto count = static_cast<Eigen::Index>(weights.size());
    return {Eigen::Map<const Edges>(ends.data(), count, 2),
            Eigen::Map<const Eigen::VectorXd>(weights.data(), count)};
}

}  // namespace

Result<IntrinsicDelaunay> intrinsicDelaunay(const MeshArrays& mesh, const EdgeTable& table,
                                            const Progress& progress) {
    FlippableSurface surface(mesh, table);
    // A queue, first in, first out: adjacent bad edges are flipped in rounds, which needs far fewer
    // flips than following one of them through the mesh.
    std::vector<int> queue;
    std::vector<char> isWaiting(static_cast<std::size_t>(surface.halfedgeCount()), 0);
    const auto enqueue = [&](std::vector<int>& list, int h) {
        h = std::max(h, surface.twin(h));
        if (isWaiting[h] == 0 && surface.wantsFlip(h)) {
            isWaiting[h] = 1;
            list.push_back(h);
        }
    };
    for (int h = 0; h < surface.halfedgeCount(); ++h) {
        enqueue(queue, h);
    }
    const auto limit = static_cast<int>(
        std::min<Eigen::Index>(kMaxFlipsPerEdge * static_cast<Eigen::Index>(table.edges.rows()),
                               std::numeric_limits<int>::max()));
    IntrinsicDelaunay result;
    std::vector<int> later;
    while (!queue.empty() && result.flips < limit) {
        later.clear();
        for (const int h : queue) {
            isWaiting[h] = 0;
            if (result.flips == limit || !surface.wantsFlip(h) || !surface.flip(h)) {
                continue;
            }
            if (++result.flips % kFlipsPerCancelCheck == 0 && progress.isCancelled()) {
                return Error{ErrorCode::Cancelled};
            }
            for (const int side : surface.sidesAround(h)) {
                enqueue(later, side);
            }
        }
        std::swap(queue, later);
    }
    for (int h = 0; h < surface.halfedgeCount() && result.complete; ++h) {
        result.complete = !surface.wantsFlip(h);
    }
    if (result.flips == 0) {
        result.graph = {table.edges, cotangentWeights(mesh, table)};
        return result;
    }
    result.graph = collect(surface, static_cast<int>(mesh.V.rows()));
    return result;
}

}  // namespace toile
