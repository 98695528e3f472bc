// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/progress.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/piece.h"
#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

int flips(const Points2& Q, const Piece& piece) {
    return flippedTriangles(triangleAreas2d(Q, piece.mesh.F), triangleAreas3d(piece.mesh));
}

/// Mean value weights preserve shapes best. On a long tube over a short outline they make triangles
/// smaller than rounding; Tutte's equal weights shrink them less, so the better result is used.
Result<Points2> fillConvex(const Piece& piece, const Points2& outline,
                           const OutlineTargets& targets, const Progress& progress) {
    auto floater =
        solveDirected(meanValueWeights(piece.mesh, piece.table),
                      static_cast<int>(piece.mesh.V.rows()), piece.boundary, outline, progress);
    const int flipped = floater ? flips(*floater, piece) : 0;
    if ((floater && flipped == 0) || (!floater && floater.error().code == ErrorCode::Cancelled)) {
        return floater;
    }
    auto tutte = tutteOnCircle(piece, progress, targets);
    if (!tutte) {
        return floater && tutte.error().code != ErrorCode::Cancelled ? floater : tutte;
    }
    return floater && flipped <= flips(*tutte, piece) ? floater : tutte;
}

constexpr int kMaxWeightings = 60;
/// Smaller exponents hardly change the map.
constexpr double kMinExponent = 0.25;
/// The iteration ends if a step lowers the stretch by less than this part.
constexpr double kWorthwhile = 1e-4;

/// Quality of a map: flips first, then stretch.
struct Rank {
    int flips = std::numeric_limits<int>::max();
    double stretch = std::numeric_limits<double>::infinity();

    bool operator<(const Rank& other) const {
        return flips != other.flips ? flips < other.flips : stretch < other.stretch;
    }
};

/// A map with its stretch, [YBS04]: for triangle T, the mean square of the singular values of its
/// plane-to-surface map; for a vertex, the mean over its triangles by 3D area; for the whole map,
/// over all.
struct Map {
    Points2 Q;
    Rank rank;
    Eigen::VectorXd vertexStretch;  ///< #V, sigma
};

Map measured(const Piece& piece, const Eigen::VectorXd& areas3d, Points2 Q) {
    const MeshArrays& mesh = piece.mesh;
    const Eigen::MatrixX2d s = singularValues(mesh, Q);
    const Eigen::ArrayXd squares =
        0.5 * (s.col(0).array().square().inverse() + s.col(1).array().square().inverse());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.V.rows());
    Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.V.rows());
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum[mesh.F(f, k)] += areas3d[f] * squares[f];
            area[mesh.F(f, k)] += areas3d[f];
        }
    }
    Map map;
    map.rank = {flippedTriangles(triangleAreas2d(Q, mesh.F), areas3d),
                std::sqrt((areas3d.array() * squares).sum() / areas3d.sum())};
    map.vertexStretch = (sum.array() / area.array()).sqrt();
    map.Q = std::move(Q);
    return map;
}

/// The weights of one of [YBS04]'s linear systems: conformal weights if all are positive, else mean
/// value weights; both keep flat neighbourhoods unchanged.
class Weights {
public:
    explicit Weights(const Piece& piece) : piece_(&piece) {
        const Eigen::VectorXd conformal = cotangentWeights(piece.mesh, piece.table);
        symmetric_ = conformal.minCoeff() > 0;
        if (symmetric_) {
            graph_ = {piece.table.edges, conformal.replicate(1, 2)};
        } else {
            graph_ = meanValueWeights(piece.mesh, piece.table);
        }
    }

    /// w_ij / sigma_j, the update of [YBS04]. If w is symmetric, the equation of vertex i is also
    /// divided by sigma_i: that changes no solution and keeps the matrix symmetric.
    Weights divided(const Eigen::ArrayXd& sigma) const {
        Weights next = *this;
        for (int e = 0; e < graph_.edges.rows(); ++e) {
            const double a = sigma[graph_.edges(e, 0)];
            const double b = sigma[graph_.edges(e, 1)];
            if (symmetric_) {
                next.graph_.weights.row(e) /= a * b;
            } else {
                next.graph_.weights(e, 0) /= b;
                next.graph_.weights(e, 1) /= a;
            }
        }
        return next;
    }

    Result<Points2> solve(const Points2& outline, const Progress& progress) const {
        return symmetric_ ? fillInterior({graph_.edges, graph_.weights.col(0)}, piece_->mesh.V,
                                         piece_->boundary, outline, progress)
                          : solveDirected(graph_, static_cast<int>(piece_->mesh.V.rows()),
                                          piece_->boundary, outline, progress);
    }

private:
    const Piece* piece_;
    DirectedEdges graph_;
    bool symmetric_ = false;
};

}  // namespace

Result<FlatPiece> flattenConvex(const Piece& piece, const FlattenOptions& /*options*/,
                                const Progress& progress, const OutlineTargets& targets) {
    const Stopwatch boundaryTime;
    const auto outline = circleOutline(outlineLengths(piece, targets));
    if (!outline) {
        return outline.error();
    }
    FlatPiece flat;
    flat.boundarySeconds = boundaryTime.seconds();
    const Stopwatch interiorTime;
    auto points = fillConvex(piece, *outline, targets, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

Result<FlatPiece> flattenStretch(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress, const OutlineTargets& targets) {
    auto flat = options.stretchOutline == StretchOutline::Curvature
                    ? flattenCurvature(piece, options, progress, targets)
                    : flattenConvex(piece, options, progress, targets);
    if (!flat) {
        return flat;
    }
    const Stopwatch time;
    const Points2 outline = flat->Q(piece.boundary, Eigen::all);
    const Eigen::VectorXd areas = triangleAreas3d(piece.mesh);
    Map best = measured(piece, areas, flat->Q);
    // [YBS04] stops if a step raises the stretch, but a smaller exponent of sigma often still
    // lowers it.
    Weights weights(piece);
    auto start = weights.solve(outline, progress);
    if (!start) {
        return start.error();
    }
    Map current = measured(piece, areas, std::move(*start));
    if (current.rank < best.rank) {
        best = current;
    }
    double exponent = 1;
    while (exponent >= kMinExponent && flat->interiorIterations < kMaxWeightings) {
        Weights next = weights.divided(current.vertexStretch.array().pow(exponent));
        auto points = next.solve(outline, progress);
        ++flat->interiorIterations;
        progress.step();
        if (!points) {
            if (points.error().code == ErrorCode::Cancelled) {
                return points.error();
            }
            break;  // weights out of the range of doubles: keep the result so far
        }
        Map moved = measured(piece, areas, std::move(*points));
        if (!(moved.rank < current.rank)) {
            exponent *= 0.5;
            continue;
        }
        const bool settled = moved.rank.flips == current.rank.flips &&
                             moved.rank.stretch > (1 - kWorthwhile) * current.rank.stretch;
        weights = std::move(next);
        current = std::move(moved);
        if (current.rank < best.rank) {
            best = current;
        }
        if (settled) {
            break;
        }
    }
    flat->Q = std::move(best.Q);
    flat->interiorSeconds += time.seconds();
    return flat;
}

}  // namespace toile
