// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/remesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "core/cut/nearest_search.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/tri_mesh.h"

namespace toile {
namespace {

/// Edges are split and collapsed at these multiples of the target length ([BK04] 4).
constexpr double kMaxEdge = 4.0 / 3, kMinEdge = 4.0 / 5;
/// Target length of the passes, relative to the wanted length: the mean turns out shorter.
constexpr double kAim = 1.02;
constexpr int kRounds = 5, kLastRounds = 2;
/// Minimum cosine between the normals of a triangle before and after a step.
constexpr double kMinTurnCosine = 0.87;
/// Minimum cosine between the normals of two triangles after a flip and their normal before.
constexpr double kMinFlipCosine = 0.9;
/// No step makes triangles of a lower quality than this, unless they were worse before.
constexpr double kMinQuality = 0.3;
/// A vertex is on a fold if the normals around it add up to less than this part of the area. A step
/// moves it off the fold by at most this part of the edge length.
constexpr double kFoldedArea = 0.8, kMaxFoldLoss = 0.05;
/// How strongly differing normals fix a vertex in its place: see `smoothed`.
constexpr int kCreaseDamping = 20;
/// Distances from the input below this are ignored, relative to the edge length.
constexpr double kSlightDistance = 0.005;
constexpr double kMaxRimLoss = 0.003;  // of length

// A corner may be removed if an edge at it is shorter than the first share of the wanted length,
// the new edge is not longer than the second, and the rim loses less than the third.
constexpr double kShortRimEdge = 0.5, kMaxRimEdge = 4.0 / 3, kMaxCornerLoss = 0.1;
constexpr int kMaxTrianglesAtVertex = 4000;  // single steps look at all of them
constexpr double kMaxTriangles = 5e6;
constexpr int kStepsPerCancelCheck = 1024;

/// Whether the result has a bounded number of triangles, and each step a bounded cost.
bool canBeRemeshed(const MeshArrays& mesh, const EdgeTable& table, double edgeLength) {
    std::vector<int> around(static_cast<std::size_t>(mesh.V.rows()), 0);
    double area = 0, divisions = 0;  // long thin triangles are divided often
    for (int f = 0; f < mesh.F.rows(); ++f) {
        area += doubleAreaNormal(mesh, f).norm() / 2;
    }
    for (int e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0), b = table.edges(e, 1);
        if (++around[a] > kMaxTrianglesAtVertex || ++around[b] > kMaxTrianglesAtVertex) {
            return false;
        }
        divisions += (mesh.V.row(b) - mesh.V.row(a)).norm() / edgeLength;
    }
    const double equilateral = std::sqrt(3) / 4 * edgeLength * edgeLength;
    return std::max(area / equilateral, divisions) < kMaxTriangles;  // false for NaN
}

class Remesher {
public:
    Remesher(const MeshArrays& input, const EdgeTable& table, double edgeLength,
             const Progress& progress);

    /// @return none if cancelled
    std::optional<MeshArrays> run();

private:
    using Vertex = TriMesh::VertexHandle;
    using Edge = TriMesh::EdgeHandle;
    using Halfedge = TriMesh::HalfedgeHandle;
    using Vector = Eigen::Vector3d;
    /// An edge to split or collapse, and its squared length at the time.
    using Candidate = std::pair<double, int>;
    enum class Role : char { Inner, Rim, Corner };

    struct Corners {
        Vector a, b, c;
        Vector normal() const { return (b - a).cross(c - a); }
        /// 1 for an equilateral triangle, 0 for one without height.
        double quality() const {
            return 2 * std::sqrt(3) * normal().norm() /
                   ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
        }
    };

    // Passes; they return false if cancelled.
    bool splitLongEdges();
    bool collapseShortEdges();
    template <class Improves>
    bool flipEdges(Improves improves);
    bool smooth();
    bool fit();

    void split(Edge e);
    bool canCollapse(Halfedge h);
    bool evensValences(Edge e) const;
    bool raisesQuality(Edge e) const;
    bool keepsTriangles(Vertex v, const Vector& p, Vertex gone = Vertex()) const;
    Vector smoothed(Vertex v) const;
    Vector smoothedOnRim(Vertex v) const;
    MeshArrays result() const;

    Vector at(Vertex v) const { return Vector::Map(mesh_.point(v).data()); }
    void moveTo(Vertex v, const Vector& p) { mesh_.set_point(v, {p.x(), p.y(), p.z()}); }
    Role roleOf(Vertex v) const { return roles_[v.idx()]; }
    Vertex tail(Halfedge h) const { return mesh_.from_vertex_handle(h); }
    Vertex head(Halfedge h) const { return mesh_.to_vertex_handle(h); }
    Vertex apex(Halfedge h) const { return head(mesh_.next_halfedge_handle(h)); }
    Halfedge alongOf(Edge e) const { return mesh_.halfedge_handle(e, 0); }
    Halfedge backOf(Edge e) const { return mesh_.halfedge_handle(e, 1); }
    Corners faceOf(Halfedge h) const { return {at(tail(h)), at(head(h)), at(apex(h))}; }
    /// Normal of the surface, with the doubled area around as its length.
    Vector normalAt(Vertex v) const {
        Vector sum = Vector::Zero();
        for (const Halfedge h : mesh_.voh_range(v)) {
            sum += mesh_.is_boundary(h) ? Vector::Zero() : faceOf(h).normal();
        }
        return sum;
    }
    double squaredLength(Edge e) const {
        return (at(head(alongOf(e))) - at(tail(alongOf(e)))).squaredNorm();
    }
    bool isThere(Edge e) const { return !mesh_.status(e).deleted(); }
    int edgeCount() const { return static_cast<int>(mesh_.n_edges()); }
    bool isCancelled() { return ++steps_ % kStepsPerCancelCheck == 0 && progress_.isCancelled(); }

    const MeshArrays& input_;
    geometry::TriangleTree<3, double> tree_;
    TriMesh mesh_;  ///< keeps deleted elements, so that handles stay valid
    double edgeLength_;
    double maxSquare_, minSquare_;  ///< squared length of an edge
    const Progress& progress_;
    std::vector<Role> roles_;     ///< per vertex
    std::vector<int> nearFaces_;  ///< per vertex: a nearby face of the input
    std::vector<int> valences_;   ///< per vertex, during flips
    std::size_t steps_ = 0;
};

Remesher::Remesher(const MeshArrays& input, const EdgeTable& table, double edgeLength,
                   const Progress& progress)
    : input_(input),
      tree_(treeOf(input)),
      mesh_(*buildTriMesh(input, table)),
      edgeLength_(kAim * edgeLength),
      maxSquare_(std::pow(kMaxEdge * edgeLength_, 2)),
      minSquare_(std::pow(kMinEdge * edgeLength_, 2)),
      progress_(progress),
      roles_(static_cast<std::size_t>(input.V.rows()), Role::Inner),
      nearFaces_(static_cast<std::size_t>(input.V.rows())) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
    for (int side = 0; side < input.F.size(); ++side) {
        nearFaces_[tailOf(input.F, side)] = side / 3;
    }
    for (const RimLoop& rim : rimsOf(input, table)) {
        for (const int v : rim.vertices) {
            roles_[v] = Role::Rim;
        }
        for (const int v : findRimCorners(input.V, rim, edgeLength_)) {
            roles_[v] = Role::Corner;
        }
    }
}

/// Longest first.
bool Remesher::splitLongEdges() {
    std::priority_queue<Candidate> queue;
    const auto consider = [&](Edge e) {
        if (const double square = squaredLength(e); square > maxSquare_) {
            queue.emplace(square, e.idx());
        }
    };
    for (const Edge e : mesh_.edges()) {
        consider(e);
    }
    while (!queue.empty()) {
        const Edge e(queue.top().second);
        queue.pop();
        if (isCancelled()) {
            return false;
        }
        const int before = edgeCount();
        split(e);
        consider(e);
        for (int added = before; added < edgeCount(); ++added) {
            consider(Edge(added));
        }
    }
    return true;
}

void Remesher::split(Edge e) {
    const Halfedge h = alongOf(e);
    const Vector middle = (at(tail(h)) + at(head(h))) / 2;
    roles_.push_back(mesh_.is_boundary(e) ? Role::Rim : Role::Inner);
    nearFaces_.push_back(nearFaces_[tail(h).idx()]);
    mesh_.split_edge(e, mesh_.new_vertex({middle.x(), middle.y(), middle.z()}));
}

/// Shortest first.
bool Remesher::collapseShortEdges() {
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
    const auto consider = [&](Edge e) {
        if (const double square = squaredLength(e); square < minSquare_) {
            queue.emplace(square, e.idx());
        }
    };
    for (const Edge e : mesh_.edges()) {
        consider(e);
    }
    while (!queue.empty()) {
        const auto [square, index] = queue.top();
        const Edge e(index);
        queue.pop();
        if (isCancelled()) {
            return false;
        }
        if (!isThere(e) || squaredLength(e) != square) {
            continue;  // its length has changed, and has an entry of its own
        }
        const Halfedge h = canCollapse(alongOf(e)) ? alongOf(e) : backOf(e);
        if (h == alongOf(e) || canCollapse(h)) {
            const Vertex kept = head(h);
            mesh_.collapse(h);
            for (const Halfedge spoke : mesh_.voh_range(kept)) {
                consider(mesh_.edge_handle(spoke));
            }
        }
    }
    return true;
}

/// Whether the tail of a half-edge can move into its head.
bool Remesher::canCollapse(Halfedge h) {
    const Vertex gone = tail(h), kept = head(h);
    const bool isOnRim = mesh_.is_boundary(mesh_.edge_handle(h));
    if (roleOf(gone) == Role::Corner || (roleOf(gone) == Role::Rim && !isOnRim)) {
        return false;
    }
    const Vector p = at(kept);
    for (const Halfedge spoke : mesh_.voh_range(gone)) {
        if ((at(head(spoke)) - p).squaredNorm() > maxSquare_) {
            return false;
        }
    }
    if (!mesh_.is_collapse_ok(h)) {
        return false;
    }
    // A tetrahedron would become two coinciding triangles.
    const Halfedge right = mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(h));
    if (!isOnRim && roleOf(apex(h)) == Role::Inner && mesh_.valence(apex(h)) == 3 &&
        apex(right) == apex(mesh_.opposite_halfedge_handle(h))) {
        return false;
    }
    return keepsTriangles(gone, p, kept);
}

/// Whether the triangles around a vertex keep their orientation and quality if it moves, and still
/// cover its place if the surface is folded there.
/// @param gone  triangles with this corner are ignored
bool Remesher::keepsTriangles(Vertex v, const Vector& p, Vertex gone) const {
    Vector normal = Vector::Zero();
    double area = 0, worstBefore = 1, worstAfter = 1;
    for (const Halfedge h : mesh_.voh_range(v)) {
        if (mesh_.is_boundary(h)) {
            continue;
        }
        const Corners before = faceOf(h), after{p, before.b, before.c};
        const Vector was = before.normal();
        normal += was;
        area += was.norm();
        worstBefore = std::min(worstBefore, before.quality());
        if (head(h) == gone || apex(h) == gone) {
            continue;
        }
        const Vector is = after.normal();
        if (!(was.dot(is) > kMinTurnCosine * was.norm() * is.norm())) {
            return false;
        }
        worstAfter = std::min(worstAfter, after.quality());
    }
    if (worstAfter < std::min(worstBefore, kMinQuality)) {
        return false;
    }
    if (roleOf(v) != Role::Inner || normal.norm() > kFoldedArea * area) {
        return true;
    }
    const Vector place = at(v);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Halfedge h : mesh_.voh_range(v)) {
        if (head(h) != gone && apex(h) != gone) {
            const Vector b = at(head(h)), c = at(apex(h)), w = nearestInTriangle(place, p, b, c);
            nearest = std::min(nearest, (w[0] * p + w[1] * b + w[2] * c - place).norm());
        }
    }
    return nearest < kMaxFoldLoss * edgeLength_;
}

template <class Improves>
bool Remesher::flipEdges(Improves improves) {
    valences_.assign(mesh_.n_vertices(), 0);
    const auto count = [this](Edge e, int change) {
        valences_[tail(alongOf(e)).idx()] += change;
        valences_[head(alongOf(e)).idx()] += change;
    };
    for (const Edge e : mesh_.edges()) {
        count(e, 1);
    }
    for (const Edge e : mesh_.edges()) {
        if (isCancelled()) {
            return false;
        }
        if (mesh_.is_boundary(e) || !improves(e)) {
            continue;
        }
        // The surface does not move: both new triangles lie in the old ones.
        const Corners left = faceOf(alongOf(e)), right = faceOf(backOf(e));
        const Vector one = Corners{right.c, left.c, left.a}.normal();
        const Vector other = Corners{left.c, right.c, left.b}.normal();
        const Vector normal = left.normal() + right.normal();
        const double least = kMinFlipCosine * normal.norm();
        if (one.dot(normal) > least * one.norm() && other.dot(normal) > least * other.norm() &&
            mesh_.is_flip_ok(e)) {
            count(e, -1);
            mesh_.flip(e);
            count(e, 1);
        }
    }
    return true;
}

/// Whether a flip brings valences closer to six, or four on a rim.
bool Remesher::evensValences(Edge e) const {
    const auto change = [this](Vertex v, int added) {
        const int excess = valences_[v.idx()] - (roleOf(v) == Role::Inner ? 6 : 4);
        return (excess + added) * (excess + added) - excess * excess;
    };
    const Halfedge h = alongOf(e), back = backOf(e);
    if (change(tail(h), -1) + change(head(h), -1) + change(apex(h), 1) + change(apex(back), 1) >=
        0) {
        return false;
    }
    constexpr double kGoodQuality = 0.5;
    const Corners left = faceOf(h), right = faceOf(back);
    const double now = std::min(Corners{right.c, left.c, left.a}.quality(),
                                Corners{left.c, right.c, left.b}.quality());
    return now > kGoodQuality || now > std::min(left.quality(), right.quality());
}

bool Remesher::raisesQuality(Edge e) const {
    constexpr double kClearly = 1.0001;  // so that no edge flips back and forth
    const Corners left = faceOf(alongOf(e)), right = faceOf(backOf(e));
    return std::min(Corners{right.c, left.c, left.a}.quality(),
                    Corners{left.c, right.c, left.b}.quality()) >
           kClearly * std::min(left.quality(), right.quality());
}

bool Remesher::smooth() {
    for (const Vertex v : mesh_.vertices()) {
        if (isCancelled()) {
            return false;
        }
        if (roleOf(v) == Role::Corner) {
            continue;
        }
        Vector p;
        if (roleOf(v) == Role::Rim) {
            p = smoothedOnRim(v);
        } else {
            const SurfacePoint nearest = nearestOn(input_, tree_, smoothed(v), nearFaces_[v.idx()]);
            if (doubleAreaNormal(input_, nearest.face).dot(normalAt(v)) < 0) {
                continue;  // the other side of thin cloth
            }
            p = positionOf(input_, nearest);
            nearFaces_[v.idx()] = nearest.face;
        }
        if (keepsTriangles(v, p)) {
            moveTo(v, p);
        }
    }
    return true;
}

/// The centroid of the triangles around a vertex, weighted by area, within its tangent plane
/// ([BK04] 4). With M the mean of n n^T over the normals around, and k = kCreaseDamping, the move
/// times (1 - M)^k stays in that plane on a flat surface, and follows a crease.
Remesher::Vector Remesher::smoothed(Vertex v) const {
    Vector p = at(v);
    Vector sum = Vector::Zero();
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    double weights = 0;
    for (const Halfedge h : mesh_.voh_range(v)) {
        const Corners face = faceOf(h);
        const Vector normal = face.normal();
        if (const double weight = normal.norm(); weight > 0) {
            normals += normal * normal.transpose() / weight;
            sum += weight * (face.b + face.c - 2 * p);
            weights += weight;
        }
    }
    if (!(weights > 0)) {
        return p;
    }
    normals /= weights;
    Vector way = sum / (2 * weights);
    for (int i = 0; i < kCreaseDamping; ++i) {
        way -= normals * way;
    }
    return p + way;
}

/// Midpoint between its neighbours along the rim.
Remesher::Vector Remesher::smoothedOnRim(Vertex v) const {
    const Halfedge ahead = mesh_.halfedge_handle(v);  // on the border
    const Vector p = at(v);
    Vector one = at(head(ahead)) - p, other = at(tail(mesh_.prev_halfedge_handle(ahead))) - p;
    if (one.squaredNorm() < other.squaredNorm()) {
        std::swap(one, other);
    }
    const double length = one.norm();
    return length > 0 ? Vector(p + one * ((length - other.norm()) / (2 * length))) : p;
}

/// Moves vertices along their normals so that the midpoints of their edges lie on the input, on
/// average: all chords of a curved surface lie on one side of it.
bool Remesher::fit() {
    std::vector<Vector> sums(mesh_.n_vertices(), Vector::Zero());
    std::vector<double> weights(mesh_.n_vertices(), 1);  // of the vertex, which is on the input
    for (const Edge e : mesh_.edges()) {
        if (isCancelled()) {
            return false;
        }
        if (mesh_.is_boundary(e)) {
            continue;
        }
        const Vertex a = tail(alongOf(e)), b = head(alongOf(e));
        const Vector middle = (at(a) + at(b)) / 2;
        const SurfacePoint nearest = nearestOn(input_, tree_, middle, nearFaces_[a.idx()]);
        const Vector offset = positionOf(input_, nearest) - middle;
        for (const Vertex v : {a, b}) {
            sums[v.idx()] += offset / 2;
            weights[v.idx()] += 0.5;
        }
    }
    for (const Vertex v : mesh_.vertices()) {
        if (roleOf(v) != Role::Inner) {
            continue;
        }
        const Vector normal = normalAt(v).normalized();
        const double move = normal.dot(sums[v.idx()]) / weights[v.idx()];
        const double much = std::abs(move) - kSlightDistance * edgeLength_;
        const Vector p = at(v) + normal * std::copysign(std::max(much, 0.0), move);
        if (much > 0 && keepsTriangles(v, p)) {
            moveTo(v, p);
        }
    }
    return true;
}

std::optional<MeshArrays> Remesher::run() {
    constexpr double kPasses = kRounds + kLastRounds + 1;
    for (int round = 0; round < kRounds; ++round) {
        if (progress_.isCancelled() || !splitLongEdges() || !collapseShortEdges() ||
            !flipEdges([this](Edge e) { return evensValences(e); }) || !smooth()) {
            return std::nullopt;
        }
        progress_.report((round + 1) / kPasses);
    }
    for (int round = 0; round < kLastRounds; ++round) {
        if (!flipEdges([this](Edge e) { return raisesQuality(e); }) || !smooth()) {
            return std::nullopt;
        }
        progress_.report((kRounds + round + 1) / kPasses);
    }
    return fit() ? std::optional(result()) : std::nullopt;
}

MeshArrays Remesher::result() const {
    std::vector<int> numbers(mesh_.n_vertices(), -1);
    MeshArrays result{Points3(mesh_.n_vertices(), 3), Triangles(mesh_.n_faces(), 3)};
    int vertices = 0, faces = 0;
    for (const Vertex v : mesh_.vertices()) {  // skips deleted vertices
        numbers[v.idx()] = vertices;
        result.V.row(vertices++) = at(v).transpose();
    }
    for (const TriMesh::FaceHandle f : mesh_.faces()) {
        Halfedge side = mesh_.halfedge_handle(f);
        for (int k = 0; k < 3; ++k, side = mesh_.next_halfedge_handle(side)) {
            result.F(faces, k) = numbers[tail(side).idx()];
        }
        ++faces;
    }
    result.V.conservativeResize(vertices, 3);
    result.F.conservativeResize(faces, 3);
    return result;
}

}  // namespace

std::optional<MeshArrays> remeshed(const MeshArrays& mesh, double edgeLength,
                                   const Progress& progress) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    if (!canBeRemeshed(mesh, table, edgeLength) || !isValidSurface(mesh, table)) {
        return std::nullopt;
    }
    return Remesher(mesh, table, edgeLength, progress).run();
}

std::vector<int> findRimCorners(const Points3& V, const RimLoop& rim, double edgeLength) {
    using Loss = std::pair<double, int>;  // mm, corner
    const int count = static_cast<int>(rim.vertices.size());
    const auto distance = [&](int i, int j) {
        return (V.row(rim.vertices[i]) - V.row(rim.vertices[j])).norm();
    };

    std::vector<int> places{0};  // of the corners in the rim
    double spare = kMaxRimLoss * rim.perimeter, length = 0;
    for (int i = 0; i < count; ++i) {
        const int ahead = (i + 1) % count;
        const double step = distance(i, ahead), longer = length + step;
        const bool isCorner = longer - distance(places.back(), ahead) > kMaxRimLoss * longer;
        if (i > 0 && (isCorner || length + longer > 2 * edgeLength)) {
            spare -= length - distance(places.back(), i);
            places.push_back(i);
            length = step;
        } else {
            length = longer;
        }
    }
    spare -= length - distance(places.back(), 0);

    // Use the remaining loss to remove corners that make short edges, cheapest first.
    int left = static_cast<int>(places.size());
    std::vector<int> next(places.size()), previous(places.size());
    for (int k = 0; k < left; ++k) {
        next[k] = (k + 1) % left;
        previous[next[k]] = k;
    }
    std::priority_queue<Loss, std::vector<Loss>, std::greater<>> queue;
    const auto lossAt = [&](int k) {
        const double before = distance(places[previous[k]], places[k]);
        const double after = distance(places[k], places[next[k]]);
        const double chord = distance(places[previous[k]], places[next[k]]);
        const double loss = before + after - chord;
        return std::min(before, after) < kShortRimEdge * edgeLength &&
                       chord < kMaxRimEdge * edgeLength && loss < kMaxCornerLoss * edgeLength
                   ? loss
                   : rim.perimeter;
    };
    for (int k = 0; k < left; ++k) {
        queue.emplace(lossAt(k), k);
    }
    while (left > 3 && queue.top().first < spare) {
        const auto [loss, k] = queue.top();
        queue.pop();
        if (places[k] < 0 || lossAt(k) != loss) {
            continue;  // its neighbours have changed
        }
        spare -= loss;
        places[k] = -1;
        --left;
        next[previous[k]] = next[k];
        previous[next[k]] = previous[k];
        queue.emplace(lossAt(next[k]), next[k]);
        queue.emplace(lossAt(previous[k]), previous[k]);
    }

    std::vector<int> corners;
    for (const int place : places) {
        if (place >= 0) {
            corners.push_back(rim.vertices[place]);
        }
    }
    return corners;
}

}  // namespace toile
