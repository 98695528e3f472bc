// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/base/stopwatch.h"
#include "core/flatten/methods/methods.h"
#include "core/garment/garment.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Of vertices equally far apart (symmetric pieces) the first is taken, whatever rounding says.
constexpr double kClearlyFarther = 1 + 1e-9;

/// Two boundary vertices far apart: the farthest from the first, and the farthest from that one.
std::array<int, 2> farPair(const Points3& V, const std::vector<int>& boundary) {
    const auto farthestFrom = [&](int from) {
        int best = boundary.front();
        for (const int v : boundary) {
            if ((V.row(v) - V.row(from)).squaredNorm() >
                kClearlyFarther * (V.row(best) - V.row(from)).squaredNorm()) {
                best = v;
            }
        }
        return best;
    };
    const int first = farthestFrom(boundary.front());
    return {first, farthestFrom(first)};
}

/// Matrix and right-hand side of the conformal energy minus the signed area with two vertices
/// held. Unknowns 2 i and 2 i + 1 are x and y of the i-th free vertex.
class NaturalSystem {
public:
    NaturalSystem(int vertexCount, std::array<int, 2> pins, double distance)
        : free_(vertexCount, 0),
          pins_(pins),
          builder_(2 * (vertexCount - 2)),
          right_(Eigen::VectorXd::Zero(2 * (vertexCount - 2))) {
        pinned_ << 0, 0, distance, 0;
        for (int v = 0, next = 0; v < vertexCount; ++v) {
            free_[v] = v == pins[0] || v == pins[1] ? -1 : next++;
        }
    }

    /// Adds `value` at (v, axis a) x (w, axis b) and at its mirror image.
    void addPair(int v, int a, int w, int b, double value) {
        if (free_[v] >= 0 && free_[w] >= 0) {
            builder_.add(2 * free_[v] + a, 2 * free_[w] + b, value);
        } else if (free_[v] >= 0) {
            right_[2 * free_[v] + a] -= value * held(w, b);
        } else if (free_[w] >= 0) {
            right_[2 * free_[w] + b] -= value * held(v, a);
        }
    }

    void addDiagonal(int v, int a, double value) {
        if (free_[v] >= 0) {
            builder_.add(2 * free_[v] + a, 2 * free_[v] + a, value);
        }
    }

    Result<Points2> solve(const Progress& progress) {
        SparseCholesky cholesky;
        const SymmetricMatrix matrix = builder_.build();
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
        const auto factorised = cholesky.factorise(matrix);
        if (!factorised) {
            return factorised.error();
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
        const auto x = cholesky.solve(right_);
        if (!x) {
            return x.error();
        }
        Points2 Q(static_cast<Eigen::Index>(free_.size()), 2);
        for (int v = 0; v < Q.rows(); ++v) {
            for (int axis = 0; axis < 2; ++axis) {
                Q(v, axis) = free_[v] < 0 ? held(v, axis) : (*x)(2 * free_[v] + axis, 0);
            }
        }
        return Q;
    }

private:
    double held(int v, int axis) const { return pinned_(v == pins_[0] ? 0 : 1, axis); }

    std::vector<int> free_;
    std::array<int, 2> pins_;
    Eigen::Matrix2d pinned_;
    SymmetricBuilder builder_;
    Eigen::VectorXd right_;
};

}  // namespace

Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& /*options*/,
                                 const Progress& progress) {
    const Stopwatch time;
    const MeshArrays& mesh = piece.mesh;
    const Edges& edges = piece.table.edges;
    const auto pins = farPair(mesh.V, piece.boundary);
    NaturalSystem system(static_cast<int>(mesh.V.rows()), pins,
                         (mesh.V.row(pins[0]) - mesh.V.row(pins[1])).norm());

    const Eigen::VectorXd weights = cotangentWeights(mesh, piece.table);
    for (int e = 0; e < edges.rows(); ++e) {
        for (int axis = 0; axis < 2; ++axis) {
            system.addDiagonal(edges(e, 0), axis, weights[e]);
            system.addDiagonal(edges(e, 1), axis, weights[e]);
            system.addPair(edges(e, 0), axis, edges(e, 1), axis, -weights[e]);
        }
    }
    // Signed area = 1/2 sum over boundary edges of (x_i y_j - x_j y_i): its Hessian is +-1/2.
    const std::size_t n = piece.boundary.size();
    for (std::size_t i = 0; i < n; ++i) {
        const int v = piece.boundary[i];
        const int w = piece.boundary[(i + 1) % n];
        system.addPair(v, 0, w, 1, -0.5);
        system.addPair(w, 0, v, 1, 0.5);
    }
    auto points = system.solve(progress);
    if (!points) {
        return points.error();
    }
    FlatPiece flat;
    const double scale = boundaryLengths3d(mesh.V, piece.boundary).sum() /
                         boundaryLengths2d(*points, piece.boundary).sum();
    flat.Q = scale * *points;
    flat.angleEnergy =
        0.5 * (boundaryAngles2d(flat.Q, piece.boundary) - boundaryAngles3d(mesh, piece.boundary))
                  .squaredNorm();
    flat.interiorSeconds = time.seconds();
    return flat;
}

}  // namespace toile
