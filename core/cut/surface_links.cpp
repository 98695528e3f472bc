// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/surface_links.h"

#include <algorithm>
#include <cmath>

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

}  // namespace toile
