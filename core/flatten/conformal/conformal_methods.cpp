// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal/conformal_methods.h"

#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/garment/garment.h"
#include "core/geometry/shortest_paths.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Of vertices equally far apart (symmetric pieces) take the first, independent of rounding.
constexpr double kClearlyFarther = 1 + 1e-9;
/// Each sweep only lengthens the pair; two or three suffice.
constexpr int kMaxSweeps = 8;

using DistancesFrom = std::function<Eigen::VectorXd(int vertex)>;

int farthest(const std::vector<int>& boundary, const Eigen::VectorXd& distance) {
    int best = boundary.front();
    for (const int v : boundary) {
        if (distance[v] > kClearlyFarther * distance[best]) {
            best = v;
        }
    }
    return best;
}

std::array<int, 2> farPair(const Piece& piece, const DistancesFrom& distancesFrom) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const int v : piece.boundary) {
        middle += piece.mesh.V.row(v) / static_cast<double>(piece.boundary.size());
    }
    int first = farthest(piece.boundary, (piece.mesh.V.rowwise() - middle).rowwise().norm());
    int second = first;
    double apart = 0;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        const Eigen::VectorXd distance = distancesFrom(first);
        const int next = farthest(piece.boundary, distance);
        if (!(distance[next] > kClearlyFarther * apart)) {
            break;
        }
        apart = distance[next];
        second = std::exchange(first, next);
    }
    return {first, second};
}

}  // namespace

std::array<int, 2> farPairInSpace(const Piece& piece) {
    return farPair(piece, [&](int v) -> Eigen::VectorXd {
        return (piece.mesh.V.rowwise() - piece.mesh.V.row(v)).rowwise().norm();
    });
}

std::array<int, 2> farPairAlongEdges(const Piece& piece) {
    const Eigen::VectorXd lengths = edgeLengths3d(piece.mesh.V, piece.table.edges);
    const std::vector<double> weights(lengths.begin(), lengths.end());
    return farPair(piece, [&](int v) -> Eigen::VectorXd {
        const auto forest = geometry::shortestForest(
            piece.table.edges, static_cast<int>(piece.mesh.V.rows()), weights, {{v}});
        return Eigen::Map<const Eigen::VectorXd>(forest.distance.data(), piece.mesh.V.rows());
    });
}

Result<FlatPiece> atTrueSize(const Piece& piece, const Points2& points, const Stopwatch& time) {
    const double scale = boundaryLengths3d(piece.mesh.V, piece.boundary).sum() /
                         boundaryLengths2d(points, piece.boundary).sum();
    FlatPiece flat;
    flat.Q = scale * points;
    if (!flat.Q.allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "flat positions"};
    }
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = time.seconds();
    return flat;
}

Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress) {
    const Stopwatch time;
    const ConformalEnergy energy(piece.mesh);
    int iterations = 0;
    const auto points = options.freeBoundary == FreeBoundary::Spectral
                            ? solveSpectral(energy, piece.boundary, iterations, progress)
                            : solvePinned(energy, farPairInSpace(piece), 1, progress);
    if (!points) {
        return points.error();
    }
    auto flat = atTrueSize(piece, *points, time);
    if (flat) {
        flat->interiorIterations = iterations;
    }
    return flat;
}

Result<FlatPiece> flattenLscm(const Piece& piece, const FlattenOptions& /*options*/,
                              const Progress& progress) {
    const Stopwatch time;
    const auto points =
        solvePinned(ConformalEnergy(piece.mesh), farPairAlongEdges(piece), 1, progress);
    if (!points) {
        return points.error();
    }
    return atTrueSize(piece, *points, time);
}

namespace {

/// With the angles of the surface.
BoundaryProblem boundaryProblemOf(const Piece& piece, const OutlineTargets& targets) {
    return {outlineLengths(piece, targets), boundaryAngles3d(piece.mesh, piece.boundary)};
}

/// Solves the boundary problem and places the interior in the outline.
/// @param interior  made here if it is needed and missing
Result<FlatPiece> solveAndFill(const Piece& piece, const FlattenOptions& options,
                               const BoundaryProblem& problem,
                               std::optional<ConformalInterior> interior,
                               const Progress& progress) {
    const Stopwatch boundaryTime;
    const auto boundary = solveBoundary(problem, options.boundarySolver, progress);
    if (!boundary) {
        return boundary.error();
    }
    FlatPiece flat;
    flat.boundarySolver = boundary->solver;
    flat.boundaryIterations = boundary->iterations;
    flat.closureGap = boundary->closureGap;
    flat.angleEnergy = boundary->energy;
    flat.boundarySeconds = boundaryTime.seconds();

    const Stopwatch interiorTime;
    const bool isConformal = options.authalic == 0;
    if (isConformal && !interior) {
        auto made = ConformalInterior::make(piece, progress);
        if (!made) {
            return made.error();
        }
        interior = std::move(*made);
    }
    auto points = isConformal ? interior->place(boundary->points, progress)
                              : fillInteriorMixed(piece.mesh, piece.table, piece.boundary,
                                                  boundary->points, options.authalic, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.delaunayFlips = isConformal ? interior->delaunayFlips() : 0;
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

}  // namespace

Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress, const OutlineTargets& targets) {
    return solveAndFill(piece, options, boundaryProblemOf(piece, targets), std::nullopt, progress);
}

Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, const OutlineTargets& targets) {
    const Stopwatch time;
    auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return interior.error();
    }
    // The logarithm u of the scale of a conformal flat metric with the same boundary lengths: L u =
    // -K inside, u = 0 on the boundary, K the angle defects to 2 pi around vertices. Its flux
    // through the boundary is the change of each boundary angle due to the interior curvature.
    const Eigen::VectorXd defects = 2 * std::numbers::pi - vertexAngles3d(piece.mesh).array();
    auto u = interior->solve(-defects, progress);
    if (!u) {
        return u.error();
    }
    const Eigen::MatrixXd flux = interior->apply(*u);
    progress.step();
    const double factorising = time.seconds();

    BoundaryProblem problem = boundaryProblemOf(piece, targets);
    problem.angles -= flux(piece.boundary, 0);
    auto flat = solveAndFill(piece, options, problem, std::move(*interior), progress);
    if (flat) {
        flat->interiorSeconds += factorising;
        if (auto note = anglesNote(piece, problem.angles)) {
            flat->notes.push_back(std::move(*note));
        }
    }
    return flat;
}

}  // namespace toile
