// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/loop_around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "core/cut/fill_holes.h"
#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/shortest_paths.h"

namespace toile {
namespace {

/// Directions in which a hole is measured: the perimeter of its hull is then exact to 0.3 %.
constexpr int kDirections = 32;

/// The outermost vertices of a loop in all directions, seen along the normal of its opening.
struct LoopHull {
    std::vector<int> outermost;  ///< per direction
    double perimeter = 0;
};

LoopHull hullOf(const Points3& V, const RimLoop& loop) {
    const std::size_t n = loop.vertices.size();
    const auto point = [&](std::size_t i) -> Eigen::Vector3d {
        return V.row(loop.vertices[i % n]) - V.row(loop.vertices[0]);
    };
    Eigen::Vector3d open = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        open += point(i).cross(point(i + 1));
    }
    // A closed slit has no normal: any direction across its first edge will do.
    const Eigen::Vector3d normal = open.isZero(0) ? point(1).unitOrthogonal() : open.normalized();
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    LoopHull hull;
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * k / kDirections;
        const Eigen::Vector3d direction = std::cos(angle) * x + std::sin(angle) * y;
        std::size_t outermost = 0;
        for (std::size_t i = 1; i < n; ++i) {
            outermost = direction.dot(point(i)) > direction.dot(point(outermost)) ? i : outermost;
        }
        hull.outermost.push_back(loop.vertices[outermost]);
        hull.perimeter += direction.dot(point(outermost)) * 2 * std::numbers::pi / kDirections;
    }
    return hull;
}

/// Smoothing steps that turn a ragged outline, longer than its cloth is wide, into a smooth one.
constexpr int kSmoothings = 4;
/// Largest shift by smoothing, as a share of the room for the ring; else the outline is kept.
constexpr double kMaxRingSmoothing = 0.05;

/// Measures of an outline, and how far its cloth ends inside the vertices, as a mean.
struct OutlineReach {
    double perimeter = 0;
    double within = 0;
    double longestEdge = 0;
};

OutlineReach reachOf(const Points3& V, const RimLoop& outline, double hullPerimeter) {
    const auto edges = [](const Points3& points) -> Points3 {
        Points3 next(points.rows(), 3);
        next << points.bottomRows(points.rows() - 1), points.topRows(1);
        return next - points;
    };
    const Points3 line = V(outline.vertices, Eigen::all);
    Points3 smooth = line;
    for (int pass = 0; pass < kSmoothings; ++pass) {
        smooth += (edges(smooth) / 2).eval();  // through the midpoints of its edges
    }
    const Eigen::Index n = line.rows(), ahead = kSmoothings / 2;
    double moved = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        moved += (smooth.row(i) - line.row((i + ahead) % n)).norm() / static_cast<double>(n);
    }
    const double room = (outline.perimeter - hullPerimeter) / (2 * std::numbers::pi);
    const double longest = edges(line).rowwise().norm().maxCoeff();
    return moved > kMaxRingSmoothing * room
               ? OutlineReach{outline.perimeter, 0, longest}
               : OutlineReach{edges(smooth).rowwise().norm().sum(), moved, longest};
}

/// Distances to the outline from the outermost points, averaged over all directions.
class WaysAcross {
public:
    WaysAcross(const SurfaceLinks& links, const RimLoop& outline, const LoopHull& hull,
               const OutlineReach& reach)
        : links_(links),
          outline_(outline),
          hull_(hull),
          reach_(reach),
          forest_(geometry::shortestForest(links.table().edges, links.vertexCount(),
                                           edgeLengths(links.mesh(), links.table().edges),
                                           {outline.vertices})) {}

    double meanAlongEdges() const {
        double sum = 0;
        for (const int v : hull_.outermost) {
            sum += forest_.distance[v];
        }
        return sum / kDirections;
    }

    double mean() const {
        double sum = 0, way = 0;
        int last = -1;
        for (const int v : hull_.outermost) {
            way = v == last ? way : wayFrom(v);
            last = v;
            sum += way;
        }
        return sum / kDirections;
    }

private:
    double wayFrom(int vertex) const {
        const std::vector<int> along = forest_.pathTo(vertex, links_.table().edges);
        if (along.size() < 2) {
            return 0;
        }
        const PathPolyline way = shortenedCut(links_, {outline_}, polylineOf(links_, along));
        // It ends at a vertex; the outline's closest point may be up to half an edge away.
        const double beside = reach_.longestEdge / 2;
        return std::sqrt(std::max(0.0, way.length * way.length - beside * beside));
    }

    const SurfaceLinks& links_;
    const RimLoop& outline_;
    const LoopHull& hull_;
    const OutlineReach& reach_;
    geometry::ShortestForest forest_;
};

double strainAcross(const SurfaceLinks& links, const RimLoop& outline, const RimLoop& hole,
                    double ignored) {
    const LoopHull hull = hullOf(links.mesh().V, hole);
    const OutlineReach reach = reachOf(links.mesh().V, outline, hull.perimeter);
    const double room = (reach.perimeter - hull.perimeter) / (2 * std::numbers::pi);
    if (room <= 0) {
        return std::numeric_limits<double>::infinity();
    }
    const WaysAcross ways(links, outline, hull, reach);
    const double atMost = (ways.meanAlongEdges() - reach.within) / room - 1;
    return atMost > ignored ? (ways.mean() - reach.within) / room - 1 : atMost;
}

}  // namespace

std::vector<double> strainsAcross(const SurfaceLinks& links, const RimLoop& outline,
                                  const std::vector<RimLoop>& holes, double ignored) {
    if (holes.size() == 1) {
        return {strainAcross(links, outline, holes.front(), ignored)};
    }
    std::vector<double> strains;
    for (std::size_t k = 0; k < holes.size(); ++k) {
        // In the plane it does not run around another hole.
        std::vector<RimLoop> others = holes;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
        const MeshArrays filled = fillHoles(links.mesh(), others);
        const EdgeTable table = buildEdgeTable(filled.F, static_cast<int>(filled.V.rows()));
        strains.push_back(strainAcross({filled, table}, outline, holes[k], ignored));
    }
    return strains;
}

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
        return cutError({}, worded("there is no tube to cut around"));
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
