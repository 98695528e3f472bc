// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/face_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"

namespace toile {
namespace {

/// A triangle in more parts than this is a tangle of lines, not a pattern: beyond it each step
/// across the triangle would take noticeable time.
constexpr std::size_t kMaxPartsOfFace = 10000;
/// Likewise, for all triangles together.
constexpr std::size_t kMaxNewVertices = 1000000;

/// Called for every part, therefore branchless.
bool holdsBoth(const FaceParts::Part& part, int a, int b) {
    const int hasA = int{part[0] == a} | int{part[1] == a} | int{part[2] == a};
    const int hasB = int{part[0] == b} | int{part[1] == b} | int{part[2] == b};
    return (hasA & hasB) != 0;
}

}  // namespace

FaceParts::FaceParts(const SurfaceLinks& links) : links_(&links), slot_(links.faceCount(), -1) {
    const Triangles& F = links.mesh().F;
    whole_.reserve(slot_.size());
    for (int f = 0; f < links.faceCount(); ++f) {
        whole_.push_back({F(f, 0), F(f, 1), F(f, 2)});
    }
}

std::vector<FaceParts::Part>& FaceParts::parts(int face) {
    if (slot_[face] < 0) {
        slot_[face] = static_cast<int>(split_.size());
        split_.push_back({whole_[face]});
        splitFace_.push_back(face);
    }
    return split_[slot_[face]];
}

int FaceParts::vertexAt(const SurfacePoint& point) const {
    const Eigen::Vector3d& at = point.barycentric;
    const auto known = vertexAt_.find({double(point.face), at[0], at[1], at[2]});
    return known == vertexAt_.end() ? -1 : known->second;
}

void FaceParts::remember(const SurfacePoint& point, int vertex) {
    const Eigen::Vector3d& at = point.barycentric;
    vertexAt_[{double(point.face), at[0], at[1], at[2]}] = vertex;
}

std::span<const FaceParts::Part> FaceParts::partsOf(int face) const {
    return slot_[face] < 0 ? std::span(&whole_[face], 1) : std::span(split_[slot_[face]]);
}

bool FaceParts::isCrowded(int face) const {
    return partsOf(face).size() > kMaxPartsOfFace || places_.size() > kMaxNewVertices;
}

SurfacePoint FaceParts::placeOf(int vertex) const {
    if (vertex < links().vertexCount()) {
        return links().cornersAt(vertex).empty() ? SurfacePoint{} : links().atVertex(vertex);
    }
    const Place& place = places_[vertex - links().vertexCount()];
    return place.edge >= 0 ? links().onEdge(place.edge, place.weights[1])
                           : SurfacePoint{place.face, place.weights};
}

Eigen::Vector3d FaceParts::weightsIn(int face, int vertex) const {
    if (vertex < links().vertexCount()) {
        return Eigen::Vector3d::Unit(links().cornerIn(face, vertex));
    }
    const Place& place = places_[vertex - links().vertexCount()];
    if (place.edge < 0) {
        return place.weights;
    }
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    weights[links().cornerIn(face, links().table().edges(place.edge, 0))] = place.weights[0];
    weights[links().cornerIn(face, links().table().edges(place.edge, 1))] = place.weights[1];
    return weights;
}

/// The side of the source triangle that both vertices lie on, or -1.
int FaceParts::sharedSide(int face, int a, int b) const {
    const Eigen::Vector3d wa = weightsIn(face, a);
    const Eigen::Vector3d wb = weightsIn(face, b);
    for (int k = 0; k < 3; ++k) {
        if (wa[(k + 2) % 3] == 0 && wb[(k + 2) % 3] == 0) {
            return k;
        }
    }
    return -1;
}

void FaceParts::replaceEdge(int face, int a, int b, int middle, int uses) {
    std::vector<Part>& list = parts(face);
    const std::size_t count = list.size();
    for (std::size_t p = 0; p < count && uses > 0; ++p) {
        if (!holdsBoth(list[p], a, b)) {
            continue;
        }
        --uses;
        for (int k = 0; k < 3; ++k) {
            const Part part = list[p];
            const int x = part[k];
            const int y = part[(k + 1) % 3];
            if ((x == a && y == b) || (x == b && y == a)) {
                list[p] = {x, middle, part[(k + 2) % 3]};
                list.push_back({middle, y, part[(k + 2) % 3]});
                break;
            }
        }
    }
}

int FaceParts::splitEdge(int face, int a, int b, double t) {
    const int vertex = vertexCount();
    const Eigen::Vector3d wa = weightsIn(face, a);
    const Eigen::Vector3d wb = weightsIn(face, b);
    const Eigen::Vector3d weights = (1 - t) * wa + t * wb;
    const int side = sharedSide(face, a, b);
    middle_[std::minmax(a, b)] = vertex;
    if (side < 0) {
        places_.push_back({-1, face, weights / weights.sum()});
        replaceEdge(face, a, b, vertex, 2);
        return vertex;
    }
    const int edge = links().table().faceEdges(face, side);
    const double along = weights[links().cornerIn(face, links().table().edges(edge, 1))];
    places_.push_back({edge, -1, {1 - along, along, 0}});
    for (const int f : links().facesOf({Carrier::Kind::Edge, edge})) {
        replaceEdge(f, a, b, vertex, 1);
    }
    return vertex;
}

int FaceParts::splitPart(int face, std::size_t part, const Eigen::Vector3d& local) {
    const Part old = parts(face)[part];
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        weights += local[k] * weightsIn(face, old[k]);
    }
    const int vertex = vertexCount();
    places_.push_back({-1, face, weights / weights.sum()});
    std::vector<Part>& list = parts(face);
    list[part] = {old[0], old[1], vertex};
    list.push_back({old[1], old[2], vertex});
    list.push_back({old[2], old[0], vertex});
    return vertex;
}

std::vector<int> FaceParts::refined(const std::vector<int>& path) const {
    std::vector<int> result;
    std::vector<int> ahead(path.rbegin(), path.rend());
    while (!ahead.empty()) {
        const int v = ahead.back();
        if (!result.empty()) {
            const auto split = middle_.find(std::minmax(result.back(), v));
            if (split != middle_.end()) {
                ahead.push_back(split->second);
                continue;
            }
        }
        ahead.pop_back();
        if (result.empty() || result.back() != v) {
            result.push_back(v);
        }
    }
    return result;
}

namespace {

/// Two opposite angles must exceed pi by this much for their edge to be flipped, so that four
/// cocircular points are not flipped forever.
constexpr double kTurnable = 1e-9;
/// A part made by a flip has at least this share of the area of the two it replaces.
constexpr double kMinShare = 1e-6;
/// Per part, in case rounding flips edges back and forth.
constexpr std::size_t kMaxWalk = 100;

/// A source triangle laid flat at its true size.
class FlatFace {
public:
    FlatFace(const FaceParts& parts, int face) : parts_(parts), face_(face) {
        const MeshArrays& mesh = parts.links().mesh();
        const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0));
        const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose() - a;
        const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose() - a;
        const double length = b.norm();
        corners_.col(0).setZero();
        corners_.col(1) << length, 0;
        corners_.col(2) << b.dot(c) / length, b.cross(c).norm() / length;
    }

    Eigen::Vector2d at(int vertex) const { return corners_ * parts_.weightsIn(face_, vertex); }

private:
    const FaceParts& parts_;
    int face_;
    Eigen::Matrix<double, 2, 3> corners_;
};

/// True if the edge a-b between the corners c (left) and d (right) should be flipped to c-d.
bool shouldTurn(const FlatFace& flat, int a, int b, int c, int d) {
    const Eigen::Vector2d pa = flat.at(a);
    const Eigen::Vector2d pb = flat.at(b);
    const Eigen::Vector2d pc = flat.at(c);
    const Eigen::Vector2d pd = flat.at(d);
    const double whole = geometry::cross(pb - pa, pc - pa) + geometry::cross(pa - pb, pd - pb);
    const double least = kMinShare * whole;
    return geometry::angleBetween(pa - pc, pb - pc) + geometry::angleBetween(pa - pd, pb - pd) >
               std::numbers::pi + kTurnable &&
           geometry::cross(pd - pa, pc - pa) > least && geometry::cross(pc - pb, pd - pb) > least;
}

}  // namespace

void FaceParts::relaxFace(int face, std::vector<Part>& list,
                          const std::set<VertexPair>& kept) const {
    const FlatFace flat(*this, face);
    std::unordered_map<std::uint64_t, std::size_t> partLeftOf;  // of directed sides
    partLeftOf.reserve(4 * list.size());
    std::vector<VertexPair> open;  // those whose two parts are still to be tested
    const auto keyOf = [](int from, int to) {
        return std::uint64_t{static_cast<std::uint32_t>(from)} << 32 | static_cast<unsigned>(to);
    };
    const auto addSidesOf = [&](std::size_t part) {
        for (int k = 0; k < 3; ++k) {
            const int a = list[part][k];
            const int b = list[part][(k + 1) % 3];
            partLeftOf[keyOf(a, b)] = part;
            open.emplace_back(std::minmax(a, b));
        }
    };
    for (std::size_t p = 0; p < list.size(); ++p) {
        addSidesOf(p);
    }
    std::vector<std::size_t> changedIn(list.size(), 0);  // the round, after which it may change
    const std::size_t limit = kMaxWalk * list.size();
    std::size_t turns = 0;
    for (std::size_t round = 1; !open.empty() && turns < limit; ++round) {
        std::ranges::sort(open);
        open.erase(std::unique(open.begin(), open.end()), open.end());
        for (const auto& [a, b] : std::exchange(open, {})) {
            const auto left = partLeftOf.find(keyOf(a, b));
            const auto right = partLeftOf.find(keyOf(b, a));
            if (left == partLeftOf.end() || right == partLeftOf.end() || kept.contains({a, b}) ||
                changedIn[left->second] == round || changedIn[right->second] == round) {
                continue;
            }
            const std::size_t p = left->second;
            const std::size_t q = right->second;
            const int c = list[p][0] + list[p][1] + list[p][2] - a - b;
            const int d = list[q][0] + list[q][1] + list[q][2] - a - b;
            if (shouldTurn(flat, a, b, c, d)) {
                list[p] = {a, d, c};
                list[q] = {b, c, d};
                partLeftOf.erase(left);
                partLeftOf.erase(right);
                addSidesOf(p);
                addSidesOf(q);
                changedIn[p] = changedIn[q] = round;
                ++turns;
            }
        }
    }
}

void FaceParts::relax(const std::set<VertexPair>& kept, const Progress& progress) {
    for (std::size_t i = 0; i < split_.size() && !progress.isCancelled(); ++i) {
        relaxFace(splitFace_[i], split_[i], kept);
    }
}

namespace {

/// A point closer to a vertex or an edge than this fraction of a triangle's size snaps to it, so
/// that slivers are rare. Vertices never move; the cut does, by that distance.
constexpr double kSnap = 0.02;
/// If snapping would not bring the path closer to its end, only vertices this close are used.
constexpr double kTouching = 1e-9;

/// A point of the reference triangle, which is equilateral with sides of length 1.
Eigen::Vector2d onReference(const Eigen::Vector3d& weights) {
    return {weights[1] + 0.5 * weights[2], 0.5 * std::sqrt(3.0) * weights[2]};
}

Eigen::Vector2d flatIn(const FaceParts& parts, int face, int vertex) {
    return onReference(parts.weightsIn(face, vertex));
}

}  // namespace

int FaceSplitter::insert(const SurfacePoint& point) {
    const Carrier carrier = parts_.links().carrierOf(point);
    if (carrier.kind == Carrier::Kind::Vertex) {
        return carrier.index;
    }
    int vertex = parts_.vertexAt(point);
    if (vertex < 0) {
        vertex = insertNew(point);
        parts_.remember(point, vertex);
    }
    return vertex;
}

int FaceSplitter::insertNew(const SurfacePoint& point) {
    const int face = point.face;
    const Eigen::Vector2d at = onReference(point.barycentric);
    const std::span<const FaceParts::Part> list = parts_.partsOf(face);
    std::size_t best = 0;
    Eigen::Vector3d local = Eigen::Vector3d::Zero();
    double depth = -std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < list.size(); ++p) {
        const Eigen::Vector2d a = flatIn(parts_, face, list[p][0]);
        const Eigen::Vector2d b = flatIn(parts_, face, list[p][1]);
        const Eigen::Vector2d c = flatIn(parts_, face, list[p][2]);
        Eigen::Vector3d here(geometry::cross(b - at, c - at), geometry::cross(c - at, a - at),
                             geometry::cross(a - at, b - at));
        here /= geometry::cross(b - a, c - a);
        if (here.minCoeff() > depth) {
            depth = here.minCoeff();
            local = here;
            best = p;
        }
    }
    const FaceParts::Part part = list[best];
    int least = 0;
    int most = 0;
    local.minCoeff(&least);
    local.maxCoeff(&most);
    if (local[most] >= 1 - kSnap) {
        return part[most];
    }
    if (local[least] < kSnap) {
        const int a = (least + 1) % 3;
        const int b = (least + 2) % 3;
        const double t = local[b] / (local[a] + local[b]);
        if (t < kSnap || t > 1 - kSnap) {
            return part[t < kSnap ? a : b];
        }
        return parts_.splitEdge(face, part[a], part[b], t);
    }
    return parts_.splitPart(face, best, local);
}

/// The next vertex on the way from one vertex to another: the target if an edge joins them, a
/// neighbour close to the straight line, or a new one where the line crosses the opposite edge. -1
/// if no part contains the vertex.
int FaceSplitter::step(int face, int from, int to) {
    const Eigen::Vector2d at = flatIn(parts_, face, from);
    const Eigen::Vector2d goal = flatIn(parts_, face, to);
    const Eigen::Vector2d direction = goal - at;
    int x = -1;
    int y = -1;
    double t = 0;
    double best = -std::numeric_limits<double>::infinity();
    for (const FaceParts::Part& part : parts_.partsOf(face)) {
        const int isSecond = int{part[1] == from}, isThird = int{part[2] == from};
        if ((int{part[0] == from} | isSecond | isThird) == 0) {  // most: without branches
            continue;
        }
        const int corner = isSecond + 2 * isThird;
        const int a = part[(corner + 1) % 3];
        const int b = part[(corner + 2) % 3];
        if (a == to || b == to) {
            return to;
        }
        const Eigen::Vector2d toA = flatIn(parts_, face, a) - at;
        const Eigen::Vector2d toB = flatIn(parts_, face, b) - at;
        // direction = alpha toA + beta toB, up to a positive factor
        const double alpha = geometry::cross(direction, toB);
        const double beta = geometry::cross(toA, direction);
        if (alpha + beta <= 0) {
            continue;
        }
        const double inside = std::min(alpha, beta) / (alpha + beta);
        if (inside > best) {
            best = inside;
            x = a;
            y = b;
            t = std::clamp(beta / (alpha + beta), 0.0, 1.0);
        }
    }
    if (x < 0) {
        return -1;
    }
    const int nearer = t < 0.5 ? x : y;
    const double gap = std::min(t, 1 - t);
    const bool approaches = (goal - flatIn(parts_, face, nearer)).norm() < direction.norm();
    if ((gap < kSnap && approaches) || gap < kTouching) {
        return nearer;
    }
    return parts_.splitEdge(face, x, y, t);
}

bool FaceSplitter::connect(int face, int from, int to, std::vector<int>& path) {
    const std::size_t limit = 4 * parts_.partsOf(face).size() + 16;
    for (std::size_t i = 0; from != to; ++i) {
        from = i < limit ? step(face, from, to) : -1;
        if (from < 0) {
            return false;
        }
        path.push_back(from);
    }
    return true;
}

}  // namespace toile
