// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/intrinsic_delaunay.h"

#include <algorithm>
#include <limits>

#include "core/mesh/cotangents.h"
#include "core/mesh/flippable_surface.h"

namespace toile {
namespace {

/// Flips between two looks at `Progress::isCancelled`; a power of two.
constexpr int kFlipsPerCancelCheck = 1 << 16;

/// An edge of the new triangulation, kept in the bucket of its smaller vertex.
struct Link {
    int larger;
    double weight;
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
    const auto eachEdge = [&surface](auto&& use) {
        for (int h = 0; h < surface.halfedgeCount(); ++h) {
            const auto [a, b] = std::minmax({surface.origin(h), surface.target(h)});
            if (h > surface.twin(h) && a != b) {
                use(a, b, h);
            }
        }
    };
    std::vector<int> bucket(static_cast<std::size_t>(vertexCount) + 1, 0);
    eachEdge([&bucket](int a, int, int) { ++bucket[a + 1]; });
    for (int v = 0; v < vertexCount; ++v) {
        bucket[v + 1] += bucket[v];
    }
    std::vector<Link> links(bucket.back());
    std::vector<int> next(bucket.begin(), bucket.end() - 1);
    eachEdge([&](int a, int b, int h) { links[next[a]++] = {b, weightOf(surface, h)}; });

    std::vector<int> ends;
    std::vector<double> weights;
    ends.reserve(2 * links.size());
    weights.reserve(links.size());
    for (int v = 0; v < vertexCount; ++v) {
        // Stable, so that parallel edges are summed in one order everywhere.
        std::stable_sort(links.begin() + bucket[v], links.begin() + bucket[v + 1],
                         [](const Link& a, const Link& b) { return a.larger < b.larger; });
        for (int k = bucket[v]; k < bucket[v + 1]; ++k) {
            if (k > bucket[v] && links[k].larger == links[k - 1].larger) {
                weights.back() += links[k].weight;
                continue;
            }
            ends.push_back(v);
            ends.push_back(links[k].larger);
            weights.push_back(links[k].weight);
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
