// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/loop_around.h"

#include <cmath>
#include <limits>

#include "core/cut/fill_holes.h"
#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"

namespace toile {
namespace {

/// Faces and rims, joined by the edges that a tree of shortest paths does not use. An edge with
/// only a disk on one side closes no loop around anything: such edges are removed from the ends,
/// except at openings, until only the others are left ([EH04]).
class LeftOverEdges {
public:
    LeftOverEdges(const SurfaceLinks& links, const geometry::ShortestForest& forest)
        : links_(links),
          isLeft_(static_cast<std::size_t>(links.edgeCount()), 1),
          rimOf_(static_cast<std::size_t>(links.vertexCount()), -1) {
        for (const int edge : forest.parentEdge) {
            if (edge >= 0) {
                isLeft_[static_cast<std::size_t>(edge)] = 0;
            }
        }
        const SortedLoops loops = sortLoops(links);
        nodes_ = links.faceCount();
        for (const auto* kind : {&loops.openings, &loops.holes}) {
            for (const RimLoop& loop : *kind) {
                for (const int v : loop.vertices) {
                    rimOf_[static_cast<std::size_t>(v)] = nodes_;
                }
                isKept_.resize(static_cast<std::size_t>(nodes_) + 1, 0);
                isKept_.back() = kind == &loops.openings ? 1 : 0;
                ++nodes_;
            }
        }
        isKept_.resize(static_cast<std::size_t>(nodes_), 0);
        prune();
    }

    bool has(int edge) const { return isLeft_[static_cast<std::size_t>(edge)] != 0; }

private:
    std::pair<int, int> sidesOf(int edge) const {
        const std::span<const int> uses = links_.table().usesOf(edge);
        return {uses[0] / 3, uses.size() > 1
                                 ? uses[1] / 3
                                 : rimOf_[static_cast<std::size_t>(links_.tail(uses[0]))]};
    }

    void prune() {
        std::vector<std::vector<int>> edgesAt(static_cast<std::size_t>(nodes_));
        for (int e = 0; e < links_.edgeCount(); ++e) {
            if (has(e)) {
                const auto [a, b] = sidesOf(e);
                edgesAt[static_cast<std::size_t>(a)].push_back(e);
                edgesAt[static_cast<std::size_t>(b)].push_back(e);
            }
        }
        std::vector<int> degree, ends;
        for (int node = 0; node < nodes_; ++node) {
            degree.push_back(static_cast<int>(edgesAt[static_cast<std::size_t>(node)].size()));
            ends.push_back(node);
        }
        while (!ends.empty()) {
            const auto node = static_cast<std::size_t>(ends.back());
            ends.pop_back();
            if (degree[node] != 1 || isKept_[node] != 0) {
                continue;
            }
            for (const int e : edgesAt[node]) {
                if (has(e)) {
                    const auto [a, b] = sidesOf(e);
                    isLeft_[static_cast<std::size_t>(e)] = 0;
                    --degree[static_cast<std::size_t>(a)];
                    --degree[static_cast<std::size_t>(b)];
                    ends.push_back(a == static_cast<int>(node) ? b : a);
                }
            }
        }
    }

    const SurfaceLinks& links_;
    std::vector<char> isLeft_;  ///< per edge
    std::vector<int> rimOf_;    ///< per vertex: the node of its rim
    std::vector<char> isKept_;  ///< per node
    int nodes_ = 0;
};

}  // namespace

Result<PathPolyline> loopAround(const SurfaceLinks& links, const SurfacePoint& place,
                                const Progress& progress) {
    const Edges& edges = links.table().edges;
    const std::vector<double> lengths = edgeLengths(links.mesh(), edges);
    int corner = 0;
    place.barycentric.maxCoeff(&corner);
    const int base = links.mesh().F(place.face, corner);
    const geometry::ShortestForest forest =
        geometry::shortestForest(edges, links.vertexCount(), lengths, {{base}}, -1, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const LeftOverEdges around(links, forest);
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int e = 0; e < links.edgeCount(); ++e) {
        const double length = forest.distance[static_cast<std::size_t>(edges(e, 0))] +
                              lengths[static_cast<std::size_t>(e)] +
                              forest.distance[static_cast<std::size_t>(edges(e, 1))];
        if (around.has(e) && length < least) {
            least = length;
            best = e;
        }
    }
    if (best < 0) {
        return cutError({}, worded("there is no tube to go around"));
    }
    PathPolyline loop;
    loop.points.push_back(place);
    const std::vector<int> out = forest.pathTo(edges(best, 0), edges);
    const std::vector<int> back = forest.pathTo(edges(best, 1), edges);
    for (const int v : out) {
        loop.points.push_back(links.atVertex(v));
    }
    for (auto v = back.rbegin(); v != back.rend(); ++v) {
        loop.points.push_back(links.atVertex(*v));
    }
    loop.points.push_back(place);
    loop.length = measuredLength(links.mesh(), loop);
    return straightened(links, loop);
}

std::vector<Eigen::Vector3d> placesAlong(const MeshArrays& mesh, const PathPolyline& loop,
                                         int count) {
    std::vector<Eigen::Vector3d> places;
    double walked = 0;
    for (std::size_t i = 0; i + 1 < loop.points.size(); ++i) {
        const Eigen::Vector3d a = positionOf(mesh, loop.points[i]);
        const Eigen::Vector3d b = positionOf(mesh, loop.points[i + 1]);
        const double length = (b - a).norm();
        for (auto next = static_cast<double>(places.size()) * loop.length / count;
             static_cast<int>(places.size()) < count && next < walked + length;
             next = static_cast<double>(places.size()) * loop.length / count) {
            places.emplace_back(a + (next - walked) / length * (b - a));
        }
        walked += length;
    }
    return places;
}

}  // namespace toile
