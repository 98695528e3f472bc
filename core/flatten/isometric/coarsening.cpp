// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/coarsening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/buckets.h"

namespace toile::isometric {
namespace {

using Triangle = std::array<int, 3>;

/// Rings longer than this are left alone: their kernels are small.
constexpr int kLongestRing = 8;
/// A triangle of this shape or better is good enough for a coarse piece.
constexpr double kGoodShape = 0.3;
/// Of the inner vertices, in a coarse piece to be solved; and of all, where it saves work.
constexpr double kKept = 0.1;
constexpr double kTooMany = 0.5;
/// A round that takes out less than this part of the vertices was the last.
constexpr double kMin = 0.02;
/// Vertices between two looks at the progress: some milliseconds.
constexpr int kLookEvery = 1 << 14;

/// Area over squared edges, 1 where equilateral; negative where flipped.
double shapeOf(double twiceArea, double squaredEdges) {
    return squaredEdges > 0 ? 2 * std::sqrt(3.0) * twiceArea / squaredEdges : 0;
}

double shape2d(const Points2& Q, int a, int b, int c) {
    const Eigen::RowVector2d ab = Q.row(b) - Q.row(a);
    const Eigen::RowVector2d ac = Q.row(c) - Q.row(a);
    return shapeOf(ab.x() * ac.y() - ab.y() * ac.x(),
                   ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
}

double shape3d(const Points3& V, int a, int b, int c) {
    const Eigen::RowVector3d ab = V.row(b) - V.row(a);
    const Eigen::RowVector3d ac = V.row(c) - V.row(a);
    return shapeOf(ab.cross(ac).norm(),
                   ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
}

}  // namespace

/// Takes vertices out, in rounds of vertices with no edge between them.
class Coarsening::Thinning {
public:
    Thinning(const MeshArrays& mesh, const EdgeLoops& loops, const Points2& Q, Coarsening& result,
             const Progress& progress)
        : V_(mesh.V),
          Q_(Q),
          result_(result),
          progress_(progress),
          triangles_(static_cast<std::size_t>(mesh.F.rows())),
          stays_(static_cast<std::size_t>(mesh.V.rows()), 0),
          gone_(static_cast<std::size_t>(mesh.V.rows()), 0) {
        for (int f = 0; f < mesh.F.rows(); ++f) {
            triangles_[f] = {mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)};
        }
        for (const int v : loops.vertices()) {
            stays_[v] = 1;
        }
        interior_ = static_cast<int>(mesh.V.rows()) - loops.count();
    }

    void thinTo(int wanted) {
        while (interior_ > wanted && !progress_.isCancelled()) {
            const int before = interior_;
            round(wanted);
            if (before - interior_ <= kMin * before) {
                break;
            }
        }
    }

    const std::vector<Triangle>& triangles() const { return triangles_; }
    bool isGone(int v) const { return gone_[v] != 0; }

private:
    void round(int wanted) {
        const auto count = static_cast<int>(V_.rows());
        stars_ = geometry::Buckets<>(count, [this](auto add) {
            for (std::size_t f = 0; f < triangles_.size(); ++f) {
                for (const int v : triangles_[f]) {
                    add(v, static_cast<int>(f));
                }
            }
        });
        std::vector<char> blocked = stays_;
        for (int v = 0; v < count && interior_ > wanted; ++v) {
            if (v % kLookEvery == 0 && progress_.isCancelled()) {
                break;
            }
            if (blocked[v] == 0 && gone_[v] == 0 && takeOut(v)) {
                for (int k = result_.removals_.back().first; k < result_.removals_.back().last;
                     ++k) {
                    blocked[result_.ring_[k]] = 1;
                }
                --interior_;
            }
        }
        std::erase_if(triangles_, [](const Triangle& t) { return t[0] < 0; });
    }

    bool takeOut(int v) {
        const std::span<const int> star = std::as_const(stars_)[v];
        const int degree = static_cast<int>(star.size());
        if (degree > kLongestRing) {
            return false;
        }
        // The edges opposite v, in star order, and then head to tail.
        std::array<int, kLongestRing> from{};
        std::array<int, kLongestRing> to{};
        double before2d = 1;
        double before3d = 1;
        for (int k = 0; k < degree; ++k) {
            const Triangle& t = triangles_[star[k]];
            const int at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
            from[k] = t[(at + 1) % 3];
            to[k] = t[(at + 2) % 3];
            before2d = std::min(before2d, shape2d(Q_, v, from[k], to[k]));
            before3d = std::min(before3d, shape3d(V_, v, from[k], to[k]));
        }
        std::array<int, kLongestRing> ring{};
        ring[0] = from[0];
        for (int k = 0; k + 1 < degree; ++k) {
            const auto* edge = std::find(from.begin(), from.begin() + degree, ring[k]);
            ring[k + 1] = to[edge - from.begin()];
        }
        int best = -1;
        double bestShape = 0;
        for (int w = 0; w < degree; ++w) {
            const double shape = shapeOnto(ring, degree, w, std::min(kGoodShape, before2d),
                                           std::min(kGoodShape, before3d));
            if (shape > bestShape) {
                best = ring[w];
                bestShape = shape;
            }
        }
        if (best < 0) {
            return false;
        }
        record(v, ring, degree);
        for (const int f : star) {
            Triangle& t = triangles_[f];
            if (std::find(t.begin(), t.end(), best) != t.end()) {
                t[0] = -1;
            } else {
                std::replace(t.begin(), t.end(), v, best);
            }
        }
        gone_[v] = 1;
        return true;
    }

    /// The worst shape in 3D of the triangles from ring vertex w; 0 where one is not good enough.
    double shapeOnto(const std::array<int, kLongestRing>& ring, int degree, int w, double least2d,
                     double least3d) const {
        double worst = 2;
        for (int k = 1; k + 1 < degree; ++k) {
            const int a = ring[(w + k) % degree];
            const int b = ring[(w + k + 1) % degree];
            const double flat = shape2d(Q_, ring[w], a, b);
            const double solid = shape3d(V_, ring[w], a, b);
            if (!(flat > 0 && flat >= least2d && solid > 0 && solid >= least3d)) {
                return 0;
            }
            worst = std::min(worst, solid);
        }
        return worst;
    }

    void record(int v, const std::array<int, kLongestRing>& ring, int degree) {
        const auto first = static_cast<int>(result_.ring_.size());
        result_.removals_.push_back({v, first, first + degree});
        std::array<double, kLongestRing> distance{};
        std::array<double, kLongestRing> halfTangent{};
        for (int k = 0; k < degree; ++k) {
            const Eigen::RowVector3d a = V_.row(ring[k]) - V_.row(v);
            const Eigen::RowVector3d b = V_.row(ring[(k + 1) % degree]) - V_.row(v);
            distance[k] = a.norm();
            halfTangent[k] = a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
        }
        double sum = 0;
        for (int k = 0; k < degree; ++k) {
            result_.ring_.push_back(ring[k]);
            const double share =
                (halfTangent[k] + halfTangent[(k + degree - 1) % degree]) / distance[k];
            result_.share_.push_back(share);
            sum += share;
        }
        for (int k = first; k < first + degree; ++k) {
            result_.share_[k] /= sum;
        }
    }

    const Points3& V_;
    const Points2& Q_;
    Coarsening& result_;
    const Progress& progress_;
    std::vector<Triangle> triangles_;
    std::vector<char> stays_;
    std::vector<char> gone_;
    geometry::Buckets<> stars_;  ///< triangles at each vertex
    int interior_ = 0;
};

Coarsening::Coarsening(const MeshArrays& mesh, const EdgeLoops& loops, const Points2& Q, int wanted,
                       const Progress& progress)
    : loops_(loops), fineCount_(mesh.V.rows()) {
    Thinning thinning(mesh, loops, Q, *this, progress);
    thinning.thinTo(wanted);
    std::vector<int> coarse(static_cast<std::size_t>(fineCount_), -1);
    for (int v = 0; v < fineCount_; ++v) {
        if (!thinning.isGone(v)) {
            coarse[v] = static_cast<int>(kept_.size());
            kept_.push_back(v);
        }
    }
    mesh_.V.resize(static_cast<Eigen::Index>(kept_.size()), 3);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        mesh_.V.row(static_cast<Eigen::Index>(k)) = mesh.V.row(kept_[k]);
    }
    const auto& triangles = thinning.triangles();
    mesh_.F.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            mesh_.F(static_cast<Eigen::Index>(f), k) = coarse[triangles[f][k]];
        }
    }
    loops_ = loops.renumbered(coarse);
}

Coarsening::Coarsening(const MeshArrays& mesh, const EdgeLoops& loops, const Points2& Q,
                       const Progress& progress)
    : Coarsening(mesh, loops, Q,
                 static_cast<int>(kKept * (static_cast<double>(mesh.V.rows()) -
                                           static_cast<double>(loops.count()))),
                 progress) {}

bool Coarsening::savesWork() const {
    return static_cast<double>(kept_.size()) <= kTooMany * static_cast<double>(fineCount_);
}

}  // namespace toile::isometric
