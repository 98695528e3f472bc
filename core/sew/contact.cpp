// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/contact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/cut/nearest_search.h"
#include "core/mesh/edge_table.h"
#include "core/sew/side_by_side.h"

namespace toile::sew {
namespace {

/// Closer to an edge or a corner than this fraction of a triangle's size, the direction to it is
/// unknown.
constexpr double kTouching = 1e-9;

/// Squared sine below which directions count as parallel.
constexpr double kParallel = 1e-12;

Eigen::Vector3d unit(const Eigen::Vector3d& v) {
    const double size = v.norm();
    return size > 0 ? Eigen::Vector3d(v / size) : Eigen::Vector3d::Zero();
}

double angleAt(const MeshArrays& mesh, Eigen::Index f, int k) {
    const Eigen::RowVector3d at = mesh.V.row(mesh.F(f, k));
    const Eigen::RowVector3d u = mesh.V.row(mesh.F(f, (k + 1) % 3)) - at;
    const Eigen::RowVector3d w = mesh.V.row(mesh.F(f, (k + 2) % 3)) - at;
    return std::atan2(u.cross(w).norm(), u.dot(w));
}

/// Projects onto the directions in which a point at `offset` from a corner of the rim is beyond it:
/// the span of its nearest point in the cone of directions beyond the corner's two rim edges.
Eigen::Matrix3d pastCorner(const Eigen::Vector3d& offset, const Eigen::Vector3d& one,
                           const Eigen::Vector3d& other) {
    const double a = offset.dot(one), b = offset.dot(other), c = one.dot(other);
    const Eigen::Matrix3d alongOne = one * one.transpose();
    if (a > c * b && b > c * a && c * c < 1 - kParallel) {
        const Eigen::Vector3d beside = (other - c * one).normalized();
        return alongOne + beside * beside.transpose();
    }
    if (std::max(a, b) <= 0) {
        return Eigen::Matrix3d::Zero();
    }
    return a >= b ? alongOne : Eigen::Matrix3d(other * other.transpose());
}

/// A signed distance changes by at most this factor times the move, plus this length, mm.
constexpr double kLeap = 1 + 1e-6;
constexpr double kSame = 1e-9;

}  // namespace

WornSurface::WornSurface(MeshArrays mesh) : mesh_(std::move(mesh)), tree_(treeOf(mesh_)) {
    const EdgeTable table = buildEdgeTable(mesh_.F, static_cast<int>(mesh_.V.rows()));
    faceEdges_ = table.faceEdges;
    faceNormals_.resize(mesh_.F.rows(), 3);
    edgeNormals_ = Points3::Zero(table.edges.rows(), 3);
    vertexNormals_ = Points3::Zero(mesh_.V.rows(), 3);
    past_ = Points3::Zero(2 * mesh_.V.rows(), 3);
    isRimEdge_.assign(static_cast<std::size_t>(table.edges.rows()), 0);
    isRimVertex_.assign(static_cast<std::size_t>(mesh_.V.rows()), 0);
    for (Eigen::Index f = 0; f < mesh_.F.rows(); ++f) {
        const Eigen::Vector3d normal = unit(doubleAreaNormal(mesh_, f));
        faceNormals_.row(f) = normal.transpose();
        for (int k = 0; k < 3; ++k) {
            edgeNormals_.row(faceEdges_(f, k)) += normal.transpose();
            vertexNormals_.row(mesh_.F(f, k)) += angleAt(mesh_, f, k) * normal.transpose();
        }
    }
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        edgeNormals_.row(e) = unit(edgeNormals_.row(e).transpose()).transpose();
        if (table.isBorder(e)) {
            isRimEdge_[e] = 1;
            const int side = table.usesOf(e)[0], tail = tailOf(mesh_.F, side);
            const int head = headOf(mesh_.F, side);
            const Eigen::Vector3d along = (mesh_.V.row(head) - mesh_.V.row(tail)).transpose();
            const Eigen::Vector3d normal = faceNormals_.row(side / 3).transpose();
            past_.row(2 * Eigen::Index{tail}) = past_.row(2 * Eigen::Index{head} + 1) =
                unit(along.cross(normal)).transpose();
            isRimVertex_[tail] = isRimVertex_[head] = 1;
        }
    }
    for (Eigen::Index v = 0; v < mesh_.V.rows(); ++v) {
        vertexNormals_.row(v) = unit(vertexNormals_.row(v).transpose()).transpose();
    }
    for (Eigen::Index f = 0; f < mesh_.F.rows(); ++f) {
        if (faceNormals_.row(f).isZero()) {
            Eigen::Vector3d about = Eigen::Vector3d::Zero();
            for (int k = 0; k < 3; ++k) {
                about += vertexNormals_.row(mesh_.F(f, k)).transpose();
            }
            faceNormals_.row(f) = unit(about).transpose();
        }
    }
}

WornSurface::Place WornSurface::placeOf(const Eigen::Vector3d& p, int near) const {
    const SurfacePoint found = nearestOn(mesh_, tree_, p, near);
    const int f = found.face;
    const Eigen::Vector3d offset = p - positionOf(mesh_, found);
    int zeros = 0, zero = 0, other = 0;
    for (int k = 0; k < 3; ++k) {
        if (found.barycentric[k] <= kOnEdge) {
            ++zeros;
            zero = k;
        } else {
            other = k;
        }
    }
    if (zeros == 0) {
        const Eigen::Vector3d normal = faceNormals_.row(f).transpose();
        return {offset.dot(normal), normal, Eigen::Matrix3d::Zero(), f};
    }
    // The edge opposite corner `zero` begins at the next corner.
    const int edge = faceEdges_(f, (zero + 1) % 3), vertex = mesh_.F(f, other);
    const Eigen::Vector3d normal =
        (zeros == 1 ? edgeNormals_.row(edge) : vertexNormals_.row(vertex)).transpose();
    // The remaining rotation about the edge or the corner.
    Eigen::Matrix3d turns = Eigen::Matrix3d::Identity();
    if (zeros == 1) {
        const Eigen::Vector3d ridge =
            unit((mesh_.V.row(mesh_.F(f, (zero + 1) % 3)) - mesh_.V.row(mesh_.F(f, (zero + 2) % 3)))
                     .transpose());
        turns -= ridge * ridge.transpose();
        if (isRimEdge_[edge] != 0) {
            return {offset.dot(normal), normal, Eigen::Matrix3d::Zero(), f};
        }
    } else if (isRimVertex_[vertex] != 0) {
        turns -= pastCorner(offset, past_.row(2 * Eigen::Index{vertex}).transpose(),
                            past_.row(2 * Eigen::Index{vertex} + 1).transpose());
    }
    const Eigen::Vector3d across = zeros == 1 ? offset : Eigen::Vector3d(turns * offset);
    const double along = across.dot(normal), distance = across.norm();
    const double size = (mesh_.V.row(mesh_.F(f, 1)) - mesh_.V.row(mesh_.F(f, 0))).norm();
    if (distance <= kTouching * size) {
        return {along, normal, Eigen::Matrix3d::Zero(), f};
    }
    const double signedDistance = along < 0 ? -distance : distance;
    const Eigen::Vector3d away = across / signedDistance;
    return {signedDistance, away, (turns - away * away.transpose()) / signedDistance, f};
}

double WornSurface::distanceTo(const Eigen::Vector3d& p) const {
    return (p - positionOf(mesh_, nearestOn(mesh_, tree_, p))).norm();
}

Contact::Contact(const WornSurface& surface, Eigen::VectorXd areas, const ContactForces& forces,
                 int threads)
    : surface_(surface), areas_(std::move(areas)), threads_(threads) {
    set(forces);
}

void Contact::set(const ContactForces& forces) {
    forces_ = forces;
    reach_ = 2 * (std::abs(forces.pressure) + forces.load) / forces.stiffness;
}

double Contact::slopeAt(double distance) const {
    return forces_.pressure + forces_.stiffness * std::min(distance - reach_, 0.0);
}

std::vector<WornSurface::Place> Contact::placesOf(const Points3& X) const {
    std::vector<WornSurface::Place> places(static_cast<std::size_t>(X.rows()));
    sideBySide(threads_, places.size(), [&](std::size_t v) {
        places[v] = surface_.placeOf(X.row(static_cast<Eigen::Index>(v)).transpose());
    });
    return places;
}

std::vector<WornSurface::Place> Contact::placesOf(
    const Points3& X, const Points3& before, const std::vector<WornSurface::Place>& places) const {
    std::vector<WornSurface::Place> now(places.size());
    sideBySide(threads_, places.size(), [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        const WornSurface::Place& old = places[v];
        const Eigen::Vector3d step = (X.row(row) - before.row(row)).transpose();
        now[v] = surface_.placeOf(X.row(row).transpose(), old.face);
        if (std::abs(now[v].distance - old.distance) > kLeap * step.norm() + kSame) {
            now[v] = {old.distance + old.away.dot(step), old.away, Eigen::Matrix3d::Zero(),
                      old.face};
        }
    });
    return now;
}

double Contact::energy(const std::vector<WornSurface::Place>& places) const {
    double sum = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double d = places[v].distance, inside = std::min(d - reach_, 0.0);
        sum += areas_[static_cast<Eigen::Index>(v)] *
               (forces_.pressure * d + forces_.stiffness * inside * inside / 2);
    }
    return sum;
}

void Contact::addGradient(const std::vector<WornSurface::Place>& places, Points3& g) const {
    for (std::size_t v = 0; v < places.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        const double slope = slopeAt(places[v].distance);
        g.row(row) += areas_[row] * slope * places[v].away.transpose();
    }
}

void Contact::addHessian(const std::vector<WornSurface::Place>& places, double caution,
                         SpaceMatrix& H) const {
    const double pull = std::max(forces_.pressure, 0.0);
    for (std::size_t v = 0; v < places.size(); ++v) {
        const double d = places[v].distance, slope = slopeAt(d);
        double stiffness = forces_.stiffness;
        if (d >= reach_) {
            stiffness = pull > 0 ? caution * pull / (d - pull / forces_.stiffness) : 0;
        }
        Eigen::Matrix3d block = stiffness * places[v].away * places[v].away.transpose();
        if (slope * d > 0) {
            block += slope * places[v].bend;
        }
        const int row = static_cast<int>(v);
        H.add(row, row, areas_[row] * block);
    }
}

}  // namespace toile::sew
