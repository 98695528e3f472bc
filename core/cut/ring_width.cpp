// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/ring_width.h"

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

}  // namespace toile
