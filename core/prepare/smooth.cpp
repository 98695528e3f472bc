// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/smooth.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/statistics.h"
#include "core/geometry/buckets.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

constexpr int kDirectionPasses = 10;
constexpr int kVertexPasses = 15;
// Directions that differ by this many times the noise smooth each other by 0.6, those of a feature
// not at all; at most 20 degrees, so that right angles survive any noise.
constexpr double kFeaturePerNoise = 4;
constexpr double kLargestFeature = 0.35;
constexpr std::size_t kLargestFan = 64;  // larger fans are not used for smoothing
constexpr int kCancelCheck = 4096;       // about a millisecond

using Directions = Points3;  // unit vectors, of triangles or of rim edges

double likeness(const Directions& N, int a, int b, double feature) {
    return std::exp((N.row(a) - N.row(b)).squaredNorm() / (-2 * feature * feature));
}

/// The noise of normals: the median of how much each differs from the mean of its neighbours, which
/// is zero on an evenly curved surface.
double noiseOf(const Triangles& F, const EdgeTable& table, const Directions& normal) {
    std::vector<double> differences;
    for (int f = 0; f < F.rows(); ++f) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        bool isInner = true;
        for (int k = 0; k < 3; ++k) {
            const int edge = table.faceEdges(f, k);
            isInner = isInner && !table.isBorder(edge);
            for (const int side : table.usesOf(edge)) {
                if (side / 3 != f) {
                    sum += normal.row(side / 3);
                }
            }
        }
        if (isInner) {
            differences.push_back((normal.row(f) - sum.normalized()).norm());
        }
    }
    if (differences.empty()) {
        return kLargestFeature;
    }
    return medianOf(std::move(differences));
}

/// A vertex on the rim, and the rim's edges before and after it: each is identified by its tail.
struct RimVertex {
    int before = -1;
    int after = -1;
};

/// Rims as lines in space: their directions play the role of a surface's normals.
class RimLines {
public:
    RimLines(const MeshArrays& mesh, const EdgeTable& table)
        : at_(static_cast<std::size_t>(mesh.V.rows())), direction_(mesh.V.rows(), 3) {
        direction_.setZero();
        length_.setZero(mesh.V.rows());
        for (int e = 0; e < table.edges.rows(); ++e) {
            if (table.isBorder(e)) {
                const int side = table.usesOf(e).front();
                const int tail = tailOf(mesh.F, side), head = headOf(mesh.F, side);
                at_[tail].after = head;
                at_[head].before = tail;
                length_[tail] = (mesh.V.row(head) - mesh.V.row(tail)).norm();
                direction_.row(tail) = (mesh.V.row(head) - mesh.V.row(tail)).normalized();
                vertices_.push_back(tail);
            }
        }
    }

    bool has(int vertex) const { return at_[vertex].after >= 0; }

    void filter(double feature) {
        Directions filtered = direction_;
        for (const int v : vertices_) {
            Eigen::RowVector3d sum = length_[v] * direction_.row(v);
            for (const int other : {at_[v].before, at_[v].after}) {
                sum += length_[other] * likeness(direction_, v, other, feature) *
                       direction_.row(other);
            }
            filtered.row(v) = sum.normalized();
        }
        direction_ = std::move(filtered);
    }

    /// Where a vertex would lie on the lines of its two edges, on average.
    Eigen::RowVector3d pull(const Points3& V, int v) const {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const auto& [edge, other] :
             {std::pair(at_[v].before, at_[v].before), std::pair(v, at_[v].after)}) {
            const Eigen::RowVector3d way = (V.row(other) - V.row(v)) / 2;
            sum += way - way.dot(direction_.row(edge)) * direction_.row(edge);
        }
        return sum / 2;
    }

private:
    std::vector<int> vertices_;
    std::vector<RimVertex> at_;
    Directions direction_;  ///< per tail
    Eigen::VectorXd length_;
};

class Smoother {
public:
    Smoother(const MeshArrays& mesh, const EdgeTable& table, double strength,
             const Progress& progress)
        : mesh_(mesh),
          strength_(strength),
          progress_(progress),
          rims_(mesh, table),
          around_(static_cast<int>(mesh.V.rows()),
                  [&mesh](auto&& add) {
                      for (int f = 0; f < mesh.F.rows(); ++f) {
                          for (int k = 0; k < 3; ++k) {
                              add(mesh.F(f, k), f);
                          }
                      }
                  }),
          normal_(mesh.F.rows(), 3),
          area_(mesh.F.rows()) {
        for (int f = 0; f < mesh.F.rows(); ++f) {
            const Eigen::Vector3d doubled = doubleAreaNormal(mesh, f);
            area_[f] = doubled.norm();
            normal_.row(f) = doubled.transpose() / area_[f];
        }
        feature_ =
            std::clamp(kFeaturePerNoise * noiseOf(mesh.F, table, normal_), 1e-6, kLargestFeature);
    }

    std::optional<Points3> run() {
        for (int pass = 0; pass < kDirectionPasses; ++pass) {
            if (!filterNormals()) {
                return std::nullopt;
            }
            rims_.filter(kLargestFeature);
            progress_.report(0.7 * (pass + 1) / kDirectionPasses);
        }
        Points3 V = mesh_.V;
        for (int pass = 0; pass < kVertexPasses; ++pass) {
            if (!moveVertices(V)) {
                return std::nullopt;
            }
            progress_.report(0.7 + 0.25 * (pass + 1) / kVertexPasses);
        }
        while (takeBack(V)) {
            if (progress_.isCancelled()) {
                return std::nullopt;
            }
        }
        return V;
    }

private:
    bool cancelledAt(int item) const { return item % kCancelCheck == 0 && progress_.isCancelled(); }

    bool filterNormals() {
        Directions filtered(normal_.rows(), 3);
        for (int f = 0; f < mesh_.F.rows(); ++f) {
            if (cancelledAt(f)) {
                return false;
            }
            Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
            for (int k = 0; k < 3; ++k) {  // a neighbour across an edge counts twice
                if (around_[mesh_.F(f, k)].size() > kLargestFan) {
                    continue;  // its neighbours also appear at the other corners
                }
                for (const int other : around_[mesh_.F(f, k)]) {
                    sum +=
                        area_[other] * likeness(normal_, f, other, feature_) * normal_.row(other);
                }
            }
            filtered.row(f) = sum.isZero(0) ? normal_.row(f) : sum.normalized();
        }
        normal_ = std::move(filtered);
        return true;
    }

    bool moveVertices(Points3& V) const {
        Points3 moved = V;
        for (int v = 0; v < V.rows(); ++v) {
            if (cancelledAt(v)) {
                return false;
            }
            Eigen::RowVector3d pull = Eigen::RowVector3d::Zero();
            if (rims_.has(v)) {
                pull = rims_.pull(V, v);
            } else if (!around_[v].empty()) {
                for (const int f : around_[v]) {
                    const Eigen::RowVector3d middle =
                        (V.row(mesh_.F(f, 0)) + V.row(mesh_.F(f, 1)) + V.row(mesh_.F(f, 2))) / 3;
                    pull += normal_.row(f).dot(middle - V.row(v)) * normal_.row(f);
                }
                pull /= static_cast<double>(around_[v].size());
            }
            Eigen::RowVector3d way = V.row(v) + pull - mesh_.V.row(v);
            const double length = way.norm();
            if (length > strength_) {
                way *= strength_ / length;
            }
            moved.row(v) = mesh_.V.row(v) + way;
        }
        V = std::move(moved);
        return true;
    }

    /// Restores the corners of triangles that have flipped or become flat; whether there were any.
    bool takeBack(Points3& V) const {
        const MeshArrays now{V, mesh_.F};
        bool any = false;
        for (int f = 0; f < mesh_.F.rows(); ++f) {
            if (shapeOf(now, f).flat ||
                doubleAreaNormal(now, f).dot(doubleAreaNormal(mesh_, f)) <= 0) {
                for (int k = 0; k < 3; ++k) {
                    const int v = mesh_.F(f, k);
                    any = any || V.row(v) != mesh_.V.row(v);
                    V.row(v) = mesh_.V.row(v);
                }
            }
        }
        return any;
    }

    const MeshArrays& mesh_;
    double strength_;
    double feature_;  ///< difference of directions that hardly smooth each other
    const Progress& progress_;
    RimLines rims_;
    geometry::Buckets<> around_;  ///< triangles, per vertex
    Directions normal_;           ///< per triangle
    Eigen::VectorXd area_;        ///< per triangle, of the original mesh; doubled
};

}  // namespace

Points3 smoothed(const MeshArrays& mesh, double strength, const Progress& progress) {
    if (strength <= 0 || mesh.F.rows() == 0) {
        return mesh.V;
    }
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    return Smoother(mesh, table, strength, progress).run().value_or(mesh.V);
}

}  // namespace toile
