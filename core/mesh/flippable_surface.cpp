// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/flippable_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"

namespace toile {
namespace {

/// What rounding of a layout does to sin(alpha + beta): the more the flatter the triangles, as
/// against their cotangents. Twice that separates an edge from the other diagonal.
constexpr double kSineTolerance = 16 * std::numeric_limits<double>::epsilon();
/// Negative by less than this part of its summands (and of one) a weight counts as zero: the four
/// corners lie on a circle but for the rounding of their coordinates.
constexpr double kWeightTolerance = 1e-12;

}  // namespace

FlippableSurface::FlippableSurface(const MeshArrays& mesh, const EdgeTable& table)
    : halfedges_(static_cast<std::size_t>(mesh.F.size())) {
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            Halfedge& halfedge = halfedges_[3 * f + k];
            halfedge.next = 3 * f + (k + 1) % 3;
            halfedge.origin = mesh.F(f, k);
            const int edge = table.faceEdges(f, k);
            const int first = table.useStart[edge];
            halfedge.twin = table.useStart[edge + 1] - first == 2
                                ? table.use[first] + table.use[first + 1] - (3 * f + k)
                                : -1;
        }
        layOut(mesh, f);
    }
}

/// From the longest side and the shortest, so that the third is long too: as a difference of two
/// long ones a short side would keep few of its digits.
void FlippableSurface::layOut(const MeshArrays& mesh, int face) {
    std::array<Eigen::Vector3d, 3> side;
    std::array<int, 3> byLength{0, 1, 2};
    for (int k = 0; k < 3; ++k) {
        side[k] = mesh.V.row(mesh.F(face, (k + 1) % 3)) - mesh.V.row(mesh.F(face, k));
    }
    std::sort(byLength.begin(), byLength.end(), [&side](int a, int b) {
        const double la = side[a].squaredNorm();
        const double lb = side[b].squaredNorm();
        return la != lb ? la < lb : a < b;
    });
    const auto [shortest, middle, longest] = byLength;
    const double length = side[longest].norm();
    // Anti-clockwise: the side after the longest one turns left, the one before it comes from
    // there.
    const double turn = shortest == (longest + 1) % 3 ? 1 : -1;
    const Eigen::Vector2d base(length, 0);
    const Eigen::Vector2d other(side[shortest].dot(side[longest]) / length,
                                turn * side[longest].cross(side[shortest]).norm() / length);
    halfedges_[3 * face + longest].vector = base;
    halfedges_[3 * face + shortest].vector = other;
    halfedges_[3 * face + middle].vector = -(base + other);
}

double FlippableSurface::oppositeCotangent(int h) const {
    const Eigen::Vector2d& a = halfedges_[next(h)].vector;
    const Eigen::Vector2d& b = halfedges_[previous(h)].vector;
    return -a.dot(b) / cross(a, b);
}

bool FlippableSurface::wantsFlip(int h) const {
    const int t = twin(h);
    if (t < 0) {
        return false;
    }
    const Eigen::Vector2d& a = halfedges_[next(h)].vector;
    const Eigen::Vector2d& b = halfedges_[previous(h)].vector;
    const Eigen::Vector2d& c = halfedges_[next(t)].vector;
    const Eigen::Vector2d& d = halfedges_[previous(t)].vector;
    // The sine of alpha + beta times the four lengths, and cot alpha + cot beta times both areas.
    const double firstArea = cross(a, b);
    const double secondArea = cross(c, d);
    const double first = -a.dot(b) * secondArea;
    const double second = -c.dot(d) * firstArea;
    const double sum = first + second;
    return sum <
               -kWeightTolerance * (std::abs(first) + std::abs(second) + firstArea * secondArea) &&
           sum * sum > kSineTolerance * kSineTolerance * a.squaredNorm() * b.squaredNorm() *
                           c.squaredNorm() * d.squaredNorm();
}

bool FlippableSurface::flip(int h) {
    const int t = twin(h);
    const int afterH = next(h);
    const int beforeH = previous(h);
    const int afterT = next(t);
    const int beforeT = previous(t);
    if (t == afterH || t == beforeH) {
        return false;  // a triangle folded around a vertex; the edge at its tip is the only one
    }
    // The twin's triangle is turned until both half-edges lie on each other: by the unit complex
    // number -vector(h) / vector(t), times the other's length.
    const Eigen::Vector2d& u = halfedges_[h].vector;
    const Eigen::Vector2d& v = halfedges_[t].vector;
    const Eigen::Vector2d turn = Eigen::Vector2d(-u.dot(v), cross(u, v)).normalized();
    const auto turned = [&turn](const Eigen::Vector2d& w) {
        return Eigen::Vector2d(turn.x() * w.x() - turn.y() * w.y(),
                               turn.y() * w.x() + turn.x() * w.y());
    };
    const Eigen::Vector2d newAfterT = turned(halfedges_[afterT].vector);
    const Eigen::Vector2d newBeforeT = turned(halfedges_[beforeT].vector);
    if (!(cross(halfedges_[beforeH].vector, newAfterT) > 0 &&
          cross(newBeforeT, halfedges_[afterH].vector) > 0)) {
        return false;
    }
    halfedges_[afterT].vector = newAfterT;
    halfedges_[beforeT].vector = newBeforeT;
    // h ran from a to b with c on its left, the twin has d on its left; now h runs from d to c.
    halfedges_[h].vector = -(halfedges_[beforeH].vector + newAfterT);
    halfedges_[t].vector = -halfedges_[h].vector;
    halfedges_[h].origin = halfedges_[beforeT].origin;
    halfedges_[t].origin = halfedges_[beforeH].origin;
    const auto link = [this](int a, int b, int c) {
        halfedges_[a].next = b;
        halfedges_[b].next = c;
        halfedges_[c].next = a;
    };
    link(h, beforeH, afterT);
    link(t, beforeT, afterH);
    return true;
}

std::array<int, 4> FlippableSurface::sidesAround(int h) const {
    const int t = twin(h);
    return {next(h), previous(h), next(t), previous(t)};
}

}  // namespace toile
