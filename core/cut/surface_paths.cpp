// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/cut/straighten.h"
#include "core/geometry/segment.h"

namespace toile {

SurfaceLinks::SurfaceLinks(const MeshArrays& mesh, const EdgeTable& table)
    : mesh_(mesh), table_(table), twin_(mesh.F.size(), -1), corners_(vertexCount(), [&](auto add) {
          for (int c = 0; c < 3 * faceCount(); ++c) {
              add(tail(c), c);
          }
      }) {
    for (int e = 0; e < edgeCount(); ++e) {
        const std::span<const int> use = table.usesOf(e);
        if (use.size() == 2 && tail(use[0]) != tail(use[1])) {
            twin_[use[0]] = use[1];
            twin_[use[1]] = use[0];
        }
    }
}

int SurfaceLinks::cornerIn(int face, int vertex) const {
    for (int k = 0; k < 3; ++k) {
        if (mesh_.F(face, k) == vertex) {
            return k;
        }
    }
    return -1;
}

double SurfaceLinks::angleAt(int corner) const {
    const int f = corner / 3;
    const int k = corner % 3;
    const auto at = mesh_.V.row(mesh_.F(f, k));
    return geometry::angleBetween(mesh_.V.row(mesh_.F(f, (k + 1) % 3)) - at,
                                  mesh_.V.row(mesh_.F(f, (k + 2) % 3)) - at);
}

bool SurfaceLinks::isInner(int vertex) const {
    return std::ranges::all_of(cornersAt(vertex), [this](int c) {
        return twin_[c] >= 0 && twin_[3 * (c / 3) + (c % 3 + 2) % 3] >= 0;
    });
}

double SurfaceLinks::angleAround(int vertex) const {
    double sum = 0;
    for (const int c : cornersAt(vertex)) {
        sum += angleAt(c);
    }
    return sum;
}

double SurfaceLinks::foldAngle(int edge) const {
    const std::span<const int> uses = table_.usesOf(edge);
    return uses.size() != 2 ? 0
                            : geometry::angleBetween(doubleAreaNormal(mesh_, uses[0] / 3),
                                                     doubleAreaNormal(mesh_, uses[1] / 3));
}

Carrier SurfaceLinks::carrierOf(const SurfacePoint& point) const {
    int positive = 0;
    int zero = -1;
    int heaviest = 0;
    for (int k = 0; k < 3; ++k) {
        if (point.barycentric[k] > kOnEdge) {
            ++positive;
        } else {
            zero = k;
        }
        if (point.barycentric[k] > point.barycentric[heaviest]) {
            heaviest = k;
        }
    }
    if (positive == 3) {
        return {Carrier::Kind::Face, point.face};
    }
    if (positive == 2) {
        return {Carrier::Kind::Edge, table_.faceEdges(point.face, (zero + 1) % 3)};
    }
    return {Carrier::Kind::Vertex, mesh_.F(point.face, heaviest)};
}

std::vector<int> SurfaceLinks::facesOf(const Carrier& carrier) const {
    std::vector<int> faces;
    if (carrier.kind == Carrier::Kind::Face) {
        faces.push_back(carrier.index);
    } else if (carrier.kind == Carrier::Kind::Edge) {
        for (const int use : table_.usesOf(carrier.index)) {
            faces.push_back(use / 3);
        }
    } else {
        for (const int c : cornersAt(carrier.index)) {
            faces.push_back(c / 3);
        }
    }
    return faces;
}

std::optional<SurfacePoint> SurfaceLinks::seenFrom(int face, const SurfacePoint& point) const {
    const Carrier carrier = carrierOf(point);
    SurfacePoint seen{face, Eigen::Vector3d::Zero()};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const bool carries =
            carrier.kind == Carrier::Kind::Vertex
                ? mesh_.F(point.face, k) == carrier.index
                : carrier.kind == Carrier::Kind::Face || point.barycentric[k] > kOnEdge;
        if (!carries) {
            continue;
        }
        const int at = face == point.face ? k : cornerIn(face, mesh_.F(point.face, k));
        if (at < 0 || (carrier.kind == Carrier::Kind::Face && face != point.face)) {
            return std::nullopt;
        }
        seen.barycentric[at] = point.barycentric[k];
        sum += point.barycentric[k];
    }
    seen.barycentric /= sum;
    return seen;
}

int SurfaceLinks::commonFace(const SurfacePoint& a, const SurfacePoint& b, int preferred) const {
    if (preferred >= 0 && seenFrom(preferred, a) && seenFrom(preferred, b)) {
        return preferred;
    }
    for (const int f : facesOf(carrierOf(a))) {
        if (seenFrom(f, b)) {
            return f;
        }
    }
    return -1;
}

SurfacePoint SurfaceLinks::atVertex(int vertex) const {
    const int corner = cornersAt(vertex).front();
    return {corner / 3, Eigen::Vector3d::Unit(corner % 3)};
}

SurfacePoint SurfaceLinks::onEdge(int edge, double t) const {
    const int use = table_.usesOf(edge)[0];
    const bool along = tail(use) == table_.edges(edge, 0);
    SurfacePoint point{use / 3, Eigen::Vector3d::Zero()};
    point.barycentric[use % 3] = along ? 1 - t : t;
    point.barycentric[(use % 3 + 1) % 3] = along ? t : 1 - t;
    return point;
}

std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges) {
    std::vector<double> lengths(edges.rows());
    for (int e = 0; e < edges.rows(); ++e) {
        lengths[e] = (mesh.V.row(edges(e, 1)) - mesh.V.row(edges(e, 0))).norm();
    }
    return lengths;
}

Result<PathPolyline> edgePath(const SurfaceLinks& links, int from, int to,
                              const Progress& progress) {
    const Edges& edges = links.table().edges;
    const geometry::ShortestForest forest = geometry::shortestForest(
        edges, links.vertexCount(), edgeLengths(links.mesh(), edges), {{from}}, to, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    if (forest.source[to] < 0) {
        return cutError({}, worded("the points lie on parts that are not connected"));
    }
    return polylineOf(links, forest.pathTo(to, edges));
}

PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices) {
    PathPolyline path;
    for (const int v : vertices) {
        path.points.push_back(links.atVertex(v));
    }
    path.length = measuredLength(links.mesh(), path);
    return path;
}

std::vector<Eigen::Vector3d> positionsOf(const MeshArrays& mesh, const PathPolyline& path) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(path.points.size());
    for (const SurfacePoint& point : path.points) {
        points.push_back(positionOf(mesh, point));
    }
    return points;
}

namespace {

/// Points on each edge in addition to its ends: more of them find the right side of a bump more
/// reliably; a mesh of few triangles needs more and can afford them.
constexpr int kFewFaces = 20000;
constexpr int kPointsOnEdgeOfFew = 3;

/// Nodes between two checks for cancellation: well below a millisecond.
constexpr int kNodesPerPoll = 1024;

/// The graph: vertices, then points on edges, then start and goal. Arcs run straight across one
/// triangle, or along its side.
class SteinerGraph {
public:
    SteinerGraph(const SurfaceLinks& links, const SurfacePoint& from, const SurfacePoint& to)
        : links_(links),
          onEdge_(links.faceCount() <= kFewFaces ? kPointsOnEdgeOfFew : 1),
          start_(links.vertexCount() + onEdge_ * links.edgeCount()),
          from_(from),
          to_(to),
          goalAt_(positionOf(links.mesh(), to)),
          goalFaces_(links.facesOf(links.carrierOf(to))),
          distance_(start_ + 2, std::numeric_limits<double>::infinity()),
          parent_(start_ + 2, -1),
          isDone_(start_ + 2, 0) {}

    bool search(const Progress& progress) {
        reach(start_, -1, 0, positionOf(links_.mesh(), from_));
        for (int count = 0; !open_.empty(); ++count) {
            if (count % kNodesPerPoll == 0 && progress.isCancelled()) {
                return false;
            }
            const int node = open_.top().second;
            open_.pop();
            if (node == start_ + 1) {
                return true;
            }
            if (isDone_[node] == 0) {
                isDone_[node] = 1;
                expand(node);
            }
        }
        return false;
    }

    PathPolyline path() const {
        PathPolyline path;
        path.length = distance_[start_ + 1];
        for (int node = start_ + 1; node >= 0; node = parent_[node]) {
            path.points.push_back(pointOf(node));
        }
        std::reverse(path.points.begin(), path.points.end());
        return path;
    }

private:
    SurfacePoint pointOf(int node) const {
        if (node < links_.vertexCount()) {
            return links_.atVertex(node);
        }
        if (node < start_) {
            const int k = node - links_.vertexCount();
            return links_.onEdge(k / onEdge_, (1.0 + k % onEdge_) / (1 + onEdge_));
        }
        return node == start_ ? from_ : to_;
    }

    void reach(int node, int parent, double distance, const Eigen::Vector3d& at) {
        if (isDone_[node] == 0 && distance < distance_[node]) {
            distance_[node] = distance;
            parent_[node] = parent;
            open_.emplace(distance + (at - goalAt_).norm(), node);
        }
    }

    void expand(int node) {
        const SurfacePoint point = pointOf(node);
        const Eigen::Vector3d at = positionOf(links_.mesh(), point);
        for (const int face : links_.facesOf(links_.carrierOf(point))) {
            expandAcross(face, node, at);
        }
    }

    void expandAcross(int face, int node, const Eigen::Vector3d& at) {
        const MeshArrays& mesh = links_.mesh();
        const double distance = distance_[node];
        if (std::ranges::find(goalFaces_, face) != goalFaces_.end()) {
            reach(start_ + 1, node, distance + (goalAt_ - at).norm(), goalAt_);
        }
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(face, k);
            const Eigen::Vector3d p = mesh.V.row(v);
            reach(v, node, distance + (p - at).norm(), p);
            const int e = links_.table().faceEdges(face, k);
            const Eigen::Vector3d a = mesh.V.row(links_.table().edges(e, 0));
            const Eigen::Vector3d b = mesh.V.row(links_.table().edges(e, 1));
            for (int j = 0; j < onEdge_; ++j) {
                const Eigen::Vector3d q = a + (1.0 + j) / (1 + onEdge_) * (b - a);
                reach(links_.vertexCount() + e * onEdge_ + j, node, distance + (q - at).norm(), q);
            }
        }
    }

    const SurfaceLinks& links_;
    int onEdge_;
    int start_;
    SurfacePoint from_, to_;
    Eigen::Vector3d goalAt_;
    std::vector<int> goalFaces_;
    std::vector<double> distance_;
    std::vector<int> parent_;
    std::vector<char> isDone_;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

Result<PathPolyline> geodesicPath(const SurfaceLinks& links, const SurfacePoint& from,
                                  const SurfacePoint& to, const Progress& progress) {
    const int common = links.commonFace(from, to);
    if (common >= 0) {
        PathPolyline path{{*links.seenFrom(common, from), *links.seenFrom(common, to)}, 0};
        path.length = measuredLength(links.mesh(), path);
        return path;
    }
    SteinerGraph graph(links, from, to);
    if (!graph.search(progress)) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        return cutError({}, worded("the points lie on parts that are not connected"));
    }
    return straightened(links, graph.path());
}

}  // namespace toile
