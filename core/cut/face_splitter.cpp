// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cut/face_parts.h"
#include "core/geometry/segment.h"

namespace toile {
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
