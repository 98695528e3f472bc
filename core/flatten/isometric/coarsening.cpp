// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/coarsening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/geometry/segment.h"
#include "core/mesh/tri_mesh.h"

namespace toile::isometric {
namespace {

using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;

/// Vertices with longer rings are not removed: the kernels of such rings are small.
constexpr int kMaxRingVertices = 8;
constexpr std::size_t kMeanDegree = 6;  // of any large triangle mesh, nearly
/// A triangle of this shape or better is good enough for a coarse piece.
constexpr double kGoodShape = 0.3;
/// Share of the inner vertices that a coarse piece keeps.
constexpr double kCoarseShare = 0.1;
/// Solving the coarse piece saves work if it keeps at most this share of all vertices.
constexpr double kMaxKeptShare = 0.5;
/// A round that removes less than this share of the inner vertices is the last one.
constexpr double kMinRemovedShare = 0.02;
constexpr int kAhead = 8;  // vertices
constexpr int kStepsPerCancelCheck = 1 << 14;

/// Area over squared edges, 1 if equilateral; negative if flipped.
double shapeOf(double twiceArea, double squaredEdges) {
    return squaredEdges > 0 ? 2 * std::sqrt(3.0) * twiceArea / squaredEdges : 0;
}

double shapeOf(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
               const Eigen::RowVector2d& c) {
    const Eigen::RowVector2d ab = b - a;
    const Eigen::RowVector2d ac = c - a;
    return shapeOf(ab.x() * ac.y() - ab.y() * ac.x(),
                   ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
}

double shapeOf(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
               const Eigen::RowVector3d& c) {
    const Eigen::RowVector3d ab = b - a;
    const Eigen::RowVector3d ac = c - a;
    return shapeOf(ab.cross(ac).norm(),
                   ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
}

/// The vertices around another one, anti-clockwise.
struct Ring {
    int degree = 0;
    std::array<Halfedge, kMaxRingVertices> out;  ///< from the vertex in the middle
    std::array<int, kMaxRingVertices> vertex;
    std::array<Eigen::RowVector2d, kMaxRingVertices> flat;
    std::array<Eigen::RowVector3d, kMaxRingVertices> solid;

    int next(int k) const { return k + 1 < degree ? k + 1 : 0; }
};

}  // namespace

/// Removes vertices, in rounds of vertices with no edge between them.
class Coarsening::Thinning {
public:
    Thinning(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
             const Points2& Q, Coarsening& result, const Progress& progress)
        : V_(mesh.V),
          Q_(Q),
          result_(result),
          progress_(progress),
          mesh_(buildTriMesh(mesh, table)),
          stays_(static_cast<std::size_t>(mesh.V.rows()), 0) {
        mesh_->request_vertex_status();
        mesh_->request_face_status();
        for (const int v : loops.vertices()) {
            stays_[v] = 1;
        }
        interior_ = static_cast<int>(mesh.V.rows()) - loops.count();
    }

    void thinTo(int wanted) {
        const auto most = static_cast<std::size_t>(std::max(interior_ - wanted, 0));
        result_.removals_.reserve(most);
        result_.ring_.reserve(kMeanDegree * most);
        result_.share_.reserve(kMeanDegree * most);
        while (interior_ > wanted && !progress_.isCancelled()) {
            const int before = interior_;
            round(wanted);
            if (before - interior_ <= kMinRemovedShare * before) {
                break;
            }
        }
    }

    const TriMesh& mesh() const { return *mesh_; }
    bool isGone(int v) const { return mesh_->status(Vertex(v)).deleted(); }

private:
    void round(int wanted) {
        const auto count = static_cast<int>(V_.rows());
        std::vector<char> blocked = stays_;
        for (int v = 0; v < count && interior_ > wanted; ++v) {
            if (v % kStepsPerCancelCheck == 0 && progress_.isCancelled()) {
                break;
            }
            // Half-edges are far apart in memory after removals: prefetch them.
            const Halfedge ahead = mesh_->halfedge_handle(Vertex(std::min(v + kAhead, count - 1)));
            __builtin_prefetch(&mesh_->halfedge(mesh_->prev_halfedge_handle(ahead)));
            if (blocked[v] == 0 && !isGone(v) && takeOut(v)) {
                for (int k = result_.removals_.back().first; k < result_.removals_.back().last;
                     ++k) {
                    blocked[result_.ring_[k]] = 1;
                }
                --interior_;
            }
        }
    }

    bool takeOut(int v) {
        Ring ring;
        for (const Halfedge h : mesh_->voh_ccw_range(Vertex(v))) {
            if (ring.degree == kMaxRingVertices) {
                return false;
            }
            ring.out[ring.degree++] = h;
        }
        // The ring begins at the triangle that comes first in the mesh.
        const auto out = std::span(ring.out).first(static_cast<std::size_t>(ring.degree));
        const auto faceAt = [this](Halfedge h) { return mesh_->face_handle(h).idx(); };
        std::rotate(out.begin(), std::ranges::min_element(out, {}, faceAt), out.end());
        for (int k = 0; k < ring.degree; ++k) {
            ring.vertex[k] = mesh_->to_vertex_handle(ring.out[k]).idx();
            ring.flat[k] = Q_.row(ring.vertex[k]);
            ring.solid[k] = V_.row(ring.vertex[k]);
        }
        double least2d = kGoodShape;
        double bestShape = kGoodShape;
        const Eigen::RowVector2d flat = Q_.row(v);
        const Eigen::RowVector3d solid = V_.row(v);
        for (int k = 0; k < ring.degree; ++k) {
            least2d = std::min(least2d, shapeOf(flat, ring.flat[k], ring.flat[ring.next(k)]));
            bestShape =
                std::min(bestShape, shapeOf(solid, ring.solid[k], ring.solid[ring.next(k)]));
        }
        int best = -1;
        for (int w = 0; w < ring.degree; ++w) {
            const double shape = shapeOnto(ring, w, least2d, bestShape);
            if (shape > (best < 0 ? 0 : bestShape)) {
                best = w;
                bestShape = shape;
            }
        }
        if (best < 0) {
            return false;
        }
        record(v, ring);
        collapse(v, ring, best);
        return true;
    }

    /// Collapses the edge from a vertex to one of its ring, three times as fast as OpenMesh's own
    /// `collapse`. Border vertices may then refer to inner half-edges; they are never removed.
    void collapse(int v, const Ring& ring, int w) {
        for (int k = 0; k < ring.degree; ++k) {
            mesh_->set_vertex_handle(mesh_->opposite_halfedge_handle(ring.out[k]),
                                     Vertex(ring.vertex[w]));
        }
        const Halfedge along = ring.out[w], back = mesh_->opposite_halfedge_handle(along);
        closeTriangle(mesh_->prev_halfedge_handle(along), mesh_->next_halfedge_handle(along));
        closeTriangle(mesh_->next_halfedge_handle(back), mesh_->prev_halfedge_handle(back));
        mesh_->status(Vertex(v)).set_deleted(true);
    }

    /// Removes the triangle of `gone`: `stays` replaces the half-edge opposite to `gone`.
    void closeTriangle(Halfedge gone, Halfedge stays) {
        mesh_->status(mesh_->face_handle(gone)).set_deleted(true);
        const Halfedge beyond = mesh_->opposite_halfedge_handle(gone);
        const auto face = mesh_->face_handle(beyond);
        mesh_->set_next_halfedge_handle(stays, mesh_->next_halfedge_handle(beyond));
        mesh_->set_next_halfedge_handle(mesh_->prev_halfedge_handle(beyond), stays);
        mesh_->set_face_handle(stays, face);
        if (mesh_->halfedge_handle(face) == beyond) {
            mesh_->set_halfedge_handle(face, stays);
        }
        for (const Halfedge h : {stays, mesh_->opposite_halfedge_handle(stays)}) {
            mesh_->set_halfedge_handle(mesh_->from_vertex_handle(h), h);
        }
    }

    /// The worst 3D shape of the triangles from ring vertex w; 0 if any is below the limits.
    double shapeOnto(const Ring& ring, int w, double least2d, double least3d) const {
        double worst = 2;
        for (int k = ring.next(w), l = ring.next(k); l != w; k = l, l = ring.next(k)) {
            const double flat = shapeOf(ring.flat[w], ring.flat[k], ring.flat[l]);
            if (!(flat > 0 && flat >= least2d)) {
                return 0;
            }
            const double solid = shapeOf(ring.solid[w], ring.solid[k], ring.solid[l]);
            if (!(solid > 0 && solid >= least3d)) {
                return 0;
            }
            worst = std::min(worst, solid);
        }
        return worst;
    }

    void record(int v, const Ring& ring) {
        const auto first = static_cast<int>(result_.ring_.size());
        result_.removals_.push_back({v, first, first + ring.degree});
        std::array<double, kMaxRingVertices> distance{};
        std::array<double, kMaxRingVertices> halfTangent{};
        for (int k = 0; k < ring.degree; ++k) {
            const Eigen::RowVector3d a = ring.solid[k] - V_.row(v);
            const Eigen::RowVector3d b = ring.solid[ring.next(k)] - V_.row(v);
            distance[k] = a.norm();
            halfTangent[k] = a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
        }
        double sum = 0;
        for (int k = 0; k < ring.degree; ++k) {
            result_.ring_.push_back(ring.vertex[k]);
            const double share =
                (halfTangent[k] + halfTangent[(k + ring.degree - 1) % ring.degree]) / distance[k];
            result_.share_.push_back(share);
            sum += share;
        }
        for (int k = first; k < first + ring.degree; ++k) {
            result_.share_[k] /= sum;
        }
    }

    const Points3& V_;
    const Points2& Q_;
    Coarsening& result_;
    const Progress& progress_;
    std::unique_ptr<TriMesh> mesh_;
    std::vector<char> stays_;
    int interior_ = 0;
};

Coarsening::Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
                       const Points2& Q, int wanted, const Progress& progress)
    : loops_(loops), fineCount_(mesh.V.rows()) {
    Thinning thinning(mesh, table, loops, Q, *this, progress);
    thinning.thinTo(wanted);
    std::vector<int> coarse(static_cast<std::size_t>(fineCount_), -1);
    for (int v = 0; v < fineCount_; ++v) {
        if (!thinning.isGone(v)) {
            coarse[v] = static_cast<int>(kept_.size());
            kept_.push_back(v);
        }
    }
    mesh_.V = mesh.V(kept_, Eigen::all);
    mesh_.F.resize(mesh.F.rows() - 2 * std::ssize(removals_), 3);
    int* corner = mesh_.F.data();
    for (const auto f : thinning.mesh().faces()) {
        for (const auto v : f.vertices()) {
            *corner++ = coarse[v.idx()];
        }
    }
    loops_ = loops.renumbered(coarse);
}

Coarsening::Coarsening(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
                       const Points2& Q, const Progress& progress)
    : Coarsening(mesh, table, loops, Q,
                 static_cast<int>(kCoarseShare * (static_cast<double>(mesh.V.rows()) -
                                                  static_cast<double>(loops.count()))),
                 progress) {}

bool Coarsening::savesWork() const {
    return static_cast<double>(kept_.size()) <= kMaxKeptShare * static_cast<double>(fineCount_);
}

namespace {

/// A point well inside the kernel of a ring: the centre of the polygon clipped by all its edges.
std::optional<Eigen::RowVector2d> kernelPoint(const Points2& Q, const int* ring, int count) {
    std::vector<Eigen::RowVector2d> polygon;
    polygon.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        polygon.emplace_back(Q.row(ring[k]));
    }
    for (int k = 0; k < count; ++k) {
        const Eigen::RowVector2d from = Q.row(ring[k]);
        const Eigen::RowVector2d edge = Q.row(ring[(k + 1) % count]) - from;
        std::vector<Eigen::RowVector2d> cut;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::RowVector2d& p = polygon[i];
            const Eigen::RowVector2d& q = polygon[(i + 1) % polygon.size()];
            const double atP = geometry::cross(edge, p - from);
            const double atQ = geometry::cross(edge, q - from);
            if (atP >= 0) {
                cut.push_back(p);
            }
            if ((atP < 0) != (atQ < 0)) {
                cut.emplace_back(p + atP / (atP - atQ) * (q - p));
            }
        }
        polygon = std::move(cut);
    }
    if (polygon.size() < 3) {
        return std::nullopt;
    }
    Eigen::RowVector2d middle = Eigen::RowVector2d::Zero();
    for (const Eigen::RowVector2d& p : polygon) {
        middle += p / static_cast<double>(polygon.size());
    }
    return middle;
}

/// True if the triangles from a vertex to its ring are all anti-clockwise.
bool sees(const Points2& Q, int v, const int* ring, int count) {
    for (int k = 0; k < count; ++k) {
        if (!(geometry::cross(Q.row(ring[k]) - Q.row(v), Q.row(ring[(k + 1) % count]) - Q.row(v)) >
              0)) {
            return false;
        }
    }
    return true;
}

}  // namespace

Points2 Coarsening::restricted(const Points2& fine) const {
    Points2 Q(static_cast<Eigen::Index>(kept_.size()), 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        Q.row(static_cast<Eigen::Index>(k)) = fine.row(kept_[k]);
    }
    return Q;
}

Points2 Coarsening::prolongedMotion(const Points2& coarse) const {
    Points2 P = Points2::Zero(fineCount_, 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        P.row(kept_[k]) = coarse.row(static_cast<Eigen::Index>(k));
    }
    for (auto removal = removals_.rbegin(); removal != removals_.rend(); ++removal) {
        for (int k = removal->first; k < removal->last; ++k) {
            P.row(removal->vertex) += share_[k] * P.row(ring_[k]);
        }
    }
    return P;
}

Points2 Coarsening::restrictedForces(Points2 fine) const {
    for (const Removal& removal : removals_) {
        for (int k = removal.first; k < removal.last; ++k) {
            fine.row(ring_[k]) += share_[k] * fine.row(removal.vertex);
        }
    }
    return restricted(fine);
}

/// @param place  gives the position of a removed vertex from the flattening so far
template <class Place>
std::optional<Points2> Coarsening::laidBack(const Points2& coarse, Place place) const {
    Points2 Q = Points2::Zero(fineCount_, 2);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        Q.row(kept_[k]) = coarse.row(static_cast<Eigen::Index>(k));
    }
    for (auto removal = removals_.rbegin(); removal != removals_.rend(); ++removal) {
        const int* ring = &ring_[removal->first];
        const int count = removal->last - removal->first;
        Q.row(removal->vertex) = place(Q, *removal);
        if (!sees(Q, removal->vertex, ring, count)) {
            const auto point = kernelPoint(Q, ring, count);
            Q.row(removal->vertex) = point.value_or(Q.row(removal->vertex));
            if (!sees(Q, removal->vertex, ring, count)) {
                return std::nullopt;
            }
        }
    }
    return Q;
}

std::optional<Points2> Coarsening::followed(const Points2& before, const Points2& coarse) const {
    return laidBack(coarse, [&](const Points2& Q, const Removal& removal) -> Eigen::RowVector2d {
        const int* ring = &ring_[removal.first];
        const int count = removal.last - removal.first;
        Eigen::RowVector2d from = Eigen::RowVector2d::Zero();
        Eigen::RowVector2d to = Eigen::RowVector2d::Zero();
        for (int k = 0; k < count; ++k) {
            from += before.row(ring[k]) / count;
            to += Q.row(ring[k]) / count;
        }
        Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
        Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
        for (int k = 0; k < count; ++k) {
            const Eigen::RowVector2d d0 = before.row(ring[k]) - from;
            const Eigen::RowVector2d d1 = Q.row(ring[k]) - to;
            D += d0.transpose() * d0;
            S += d0.transpose() * d1;
        }
        return to + (before.row(removal.vertex) - from) * (D.inverse() * S);
    });
}

std::optional<Points2> Coarsening::prolonged(const Points2& coarse) const {
    return laidBack(coarse, [&](const Points2& Q, const Removal& removal) {
        Eigen::RowVector2d place = Eigen::RowVector2d::Zero();
        for (int k = removal.first; k < removal.last; ++k) {
            place += share_[k] * Q.row(ring_[k]);
        }
        return place;
    });
}

}  // namespace toile::isometric
