// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/intrinsic_delaunay.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/buckets.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/flippable_surface.h"

namespace toile {
namespace {

/// Flips between two looks at `Progress::isCancelled`; a power of two.
constexpr int kFlipsPerCancelCheck = 1 << 16;

/// An edge of the new triangulation, kept in the bucket of its smaller vertex.
struct Link {
    int larger;
    int halfedge;  ///< of its two the one of larger number
};

/// A negative weight of an edge that does not want to be turned is rounding.
double weightOf(const FlippableSurface& surface, int h) {
    const int twin = surface.twin(h);
    if (twin < 0) {
        return 0.5 * surface.oppositeCotangent(h);
    }
    const double weight = 0.5 * (surface.oppositeCotangent(h) + surface.oppositeCotangent(twin));
    return weight < 0 && !surface.wantsFlip(h) ? 0 : weight;
}

/// Each edge once, sorted, parallel ones summed, in linear time as `buildEdgeTable` does it.
WeightedEdges collect(const FlippableSurface& surface, int vertexCount) {
    Buckets<Link> links(vertexCount, [&surface](auto add) {
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
        // Stable, so that parallel edges are summed in one order everywhere.
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
    // First in, first out, in rounds: bad edges next to each other wait for each other's turn,
    // which takes a fraction of the flips that following one of them through the mesh does.
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
        std::min<Eigen::Index>(kMostFlipsPerEdge * static_cast<Eigen::Index>(table.edges.rows()),
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
                return Error{ErrorCode::Cancelled, "", ""};
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
