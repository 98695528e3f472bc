// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/stopwatch.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/authalic.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

Result<Points2> placeInterior(const Piece& piece, const FlattenOptions& options,
                              const Points2& outline, FlatPiece& flat, const Progress& progress) {
    if (options.authalic != 0) {
        return fillInteriorMixed(piece.mesh, piece.table, piece.boundary, outline, options.authalic,
                                 progress);
    }
    auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return interior.error();
    }
    auto points = interior->place(outline, progress);
    flat.delaunayFlips = interior->delaunayFlips();
    return points;
}

}  // namespace

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
    auto points = placeInterior(piece, options, boundary->points, flat, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

}  // namespace toile
