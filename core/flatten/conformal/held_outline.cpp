// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// By the angles that the surface has.
BoundaryProblem boundaryProblemOf(const Piece& piece) {
    return {boundaryLengths3d(piece.mesh.V, piece.boundary),
            boundaryAngles3d(piece.mesh, piece.boundary)};
}

/// The outline that solves the boundary problem, and the interior in it.
/// @param interior  made here where it is needed and not there
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
                                  const Progress& progress) {
    return solveAndFill(piece, options, boundaryProblemOf(piece), std::nullopt, progress);
}

Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress) {
    const Stopwatch time;
    auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return interior.error();
    }
    // The logarithm u of the scale of a conformal flat metric that keeps the boundary's lengths:
    // L u = -K inside, u = 0 on the boundary, K what the angles around a vertex lack of 2 pi. Its
    // flux through the boundary is what the interior curvature takes from each boundary angle.
    const Eigen::VectorXd defects = 2 * std::numbers::pi - vertexAngles3d(piece.mesh).array();
    auto u = interior->solve(-defects, progress);
    if (!u) {
        return u.error();
    }
    const Eigen::MatrixXd flux = interior->apply(*u);
    progress.step();
    const double factorising = time.seconds();

    BoundaryProblem problem = boundaryProblemOf(piece);
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
