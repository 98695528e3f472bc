// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/cut/surface_paths.h"
#include "core/geometry/disjoint_sets.h"

namespace toile {
namespace {

/// A vertex that lacks at least this much of a full turn is a corner that a seam should reach.
constexpr double kSharpVertex = std::numbers::pi / 5;
constexpr int kMaxPeaks = 16;
constexpr int kBasePointsTried = 6;

struct Candidate {
    double length;
    int edge;
};

/// The path from source to source across an edge.
std::vector<int> pathOver(const SurfaceLinks& links, const geometry::ShortestForest& forest,
                          int edge) {
    const Edges& edges = links.table().edges;
    std::vector<int> way = forest.pathTo(edges(edge, 0), edges);
    const std::vector<int> rest = forest.pathTo(edges(edge, 1), edges);
    way.insert(way.end(), rest.rbegin(), rest.rend());
    return way;
}

/// Edges outside the forest, with the length of the path across each.
std::vector<Candidate> outside(const SurfaceLinks& links, const geometry::ShortestForest& forest,
                               const std::vector<double>& weights) {
    const Edges& edges = links.table().edges;
    std::vector<Candidate> candidates;
    for (int e = 0; e < links.edgeCount(); ++e) {
        if (!links.table().isBorder(e) && forest.parentEdge[edges(e, 0)] != e &&
            forest.parentEdge[edges(e, 1)] != e) {
            candidates.push_back(
                {forest.distance[edges(e, 0)] + weights[e] + forest.distance[edges(e, 1)], e});
        }
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::length);
    return candidates;
}

/// The remaining paths after a tree of faces has crossed as many of the expensive edges as it can.
std::vector<Candidate> leftOver(const SurfaceLinks& links, const std::vector<Candidate>& sorted) {
    geometry::DisjointSets faces(links.faceCount());
    std::vector<Candidate> left;
    for (auto candidate = sorted.rbegin(); candidate != sorted.rend(); ++candidate) {
        const std::span<const int> use = links.table().usesOf(candidate->edge);
        if (faces.root(use[0] / 3) == faces.root(use[1] / 3)) {
            left.push_back(*candidate);
        } else {
            faces.join(use[0] / 3, use[1] / 3);
        }
    }
    std::reverse(left.begin(), left.end());
    return left;
}

int farthest(const geometry::ShortestForest& forest) {
    int best = 0;
    for (std::size_t v = 0; v < forest.distance.size(); ++v) {
        const double d = forest.distance[v];
        if (std::isfinite(d) && d > forest.distance[best]) {
            best = static_cast<int>(v);
        }
    }
    return best;
}

/// The sharpest vertices, or the two ends of the piece.
std::vector<int> peaks(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<std::pair<double, int>> sharp;
    for (int v = 0; v < links.vertexCount(); ++v) {
        const double missing = 2 * std::numbers::pi - links.angleAround(v);
        if (missing > kSharpVertex && !links.cornersAt(v).empty()) {
            sharp.emplace_back(-missing, v);
        }
    }
    std::sort(sharp.begin(), sharp.end());
    std::vector<int> result;
    for (std::size_t i = 0; i < sharp.size() && i < kMaxPeaks; ++i) {
        result.push_back(sharp[i].second);
    }
    const auto from = [&](int v) {
        return geometry::shortestForest(links.table().edges, links.vertexCount(), weights, {{v}});
    };
    if (result.empty()) {
        result.push_back(farthest(from(links.mesh().F(0, 0))));
    }
    if (result.size() == 1) {
        result.push_back(farthest(from(result.front())));
    }
    return result;
}

/// A graph of paths along edges, which is then split at its branchings.
class EdgeSet {
public:
    void add(const std::vector<int>& way) {
        for (std::size_t i = 1; i < way.size(); ++i) {
            neighbours_[way[i - 1]].insert(way[i]);
            neighbours_[way[i]].insert(way[i - 1]);
        }
    }

    /// Removes dead ends until every end is part of a loop.
    void prune() {
        std::vector<int> ends;
        for (const auto& [v, around] : neighbours_) {
            ends.push_back(v);
        }
        while (!ends.empty()) {
            const int v = ends.back();
            ends.pop_back();
            if (neighbours_[v].size() == 1) {
                const int w = *neighbours_[v].begin();
                remove(v, w);
                ends.push_back(w);
            }
        }
    }

    /// The graph as paths between its branchings and ends; a loop without either starts anywhere.
    std::vector<std::vector<int>> takeApart() {
        std::set<int> stops;
        for (const auto& [v, around] : neighbours_) {
            if (around.size() != 2) {
                stops.insert(v);
            }
        }
        std::vector<std::vector<int>> ways;
        for (const int v : stops) {
            while (!neighbours_[v].empty()) {
                ways.push_back(walk(v, stops));
            }
        }
        for (const auto& [v, around] : neighbours_) {
            if (!around.empty()) {
                ways.push_back(walk(v, {v}));
            }
        }
        return ways;
    }

private:
    void remove(int v, int w) {
        neighbours_[v].erase(w);
        neighbours_[w].erase(v);
    }

    std::vector<int> walk(int v, const std::set<int>& stops) {
        std::vector<int> way{v};
        do {
            const int next = *neighbours_[v].begin();
            remove(v, next);
            v = next;
            way.push_back(v);
        } while (!stops.contains(v));
        return way;
    }

    std::map<int, std::set<int>> neighbours_;
};

}  // namespace

EdgeWays arcsBetweenRims(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<int> rim;
    for (int use = 0; use < 3 * links.faceCount(); ++use) {
        if (links.twin(use) < 0) {
            rim.push_back(links.tail(use));
        }
    }
    const geometry::ShortestForest forest =
        geometry::shortestForest(links.table().edges, links.vertexCount(), weights, {rim});
    EdgeWays arcs;
    for (const Candidate& c : leftOver(links, outside(links, forest, weights))) {
        arcs.push_back(pathOver(links, forest, c.edge));
    }
    return arcs;
}

EdgeWays loopsAroundHandles(const SurfaceLinks& links, const std::vector<double>& weights) {
    EdgeWays best;
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> tried{links.mesh().F(0, 0)};
    for (int i = 0; i < kBasePointsTried; ++i) {
        const geometry::ShortestForest forest = geometry::shortestForest(
            links.table().edges, links.vertexCount(), weights, {{tried.back()}});
        double total = 0;
        EdgeSet graph;
        for (const Candidate& c : leftOver(links, outside(links, forest, weights))) {
            total += c.length;
            graph.add(pathOver(links, forest, c.edge));
        }
        if (total < least) {
            least = total;
            graph.prune();
            best = graph.takeApart();
        }
        std::vector<std::vector<int>> sources{tried};
        tried.push_back(farthest(
            geometry::shortestForest(links.table().edges, links.vertexCount(), weights, sources)));
    }
    return best;
}

EdgeWays treeThroughPeaks(const SurfaceLinks& links, const std::vector<double>& weights) {
    std::vector<std::vector<int>> sources;
    for (const int v : peaks(links, weights)) {
        sources.push_back({v});
    }
    const geometry::ShortestForest forest =
        geometry::shortestForest(links.table().edges, links.vertexCount(), weights, sources);
    geometry::DisjointSets joined(static_cast<int>(sources.size()));
    EdgeSet tree;
    for (const Candidate& c : outside(links, forest, weights)) {
        const auto ends = links.table().edges.row(c.edge);
        const int a = forest.source[ends[0]];
        const int b = forest.source[ends[1]];
        if (joined.root(a) != joined.root(b)) {
            joined.join(a, b);
            tree.add(pathOver(links, forest, c.edge));
        }
    }
    return tree.takeApart();
}

}  // namespace toile
