// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/stopwatch.h"
#include "core/flatten/boundary_problem.h"
#include "core/flatten/interior.h"
#include "core/flatten/methods/methods.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"

namespace toile {

Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress) {
    const Stopwatch boundaryTime;
    const BoundaryProblem problem{boundaryLengths3d(piece.mesh.V, piece.boundary),
                                  boundaryAngles3d(piece.mesh, piece.boundary)};
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
    auto points = fillInterior(piece.mesh, piece.table, piece.boundary, boundary->points, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

}  // namespace toile
