// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/base/stopwatch.h"
#include "core/flatten/boundary/circle_outline.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

int flips(const Points2& Q, const Piece& piece) {
    return flippedTriangles(triangleAreas2d(Q, piece.mesh.F));
}

/// Mean value weights keep shapes best. On a long tube over a short outline they make triangles
/// smaller than rounding; Tutte's equal weights shrink them less, so the better one is taken.
Result<Points2> fillConvex(const Piece& piece, const Points2& outline, const Progress& progress) {
    auto floater =
        solveDirected(meanValueWeights(piece.mesh, piece.table),
                      static_cast<int>(piece.mesh.V.rows()), piece.boundary, outline, progress);
    const int flipped = floater ? flips(*floater, piece) : 0;
    if ((floater && flipped == 0) || (!floater && floater.error().code == ErrorCode::Cancelled)) {
        return floater;
    }
    auto tutte = tutteOnCircle(piece, progress);
    if (!tutte) {
        return floater && tutte.error().code != ErrorCode::Cancelled ? floater : tutte;
    }
    return floater && flipped <= flips(*tutte, piece) ? floater : tutte;
}

}  // namespace

Result<FlatPiece> flattenConvex(const Piece& piece, const FlattenOptions& /*options*/,
                                const Progress& progress) {
    const Stopwatch boundaryTime;
    const auto outline = circleOutline(boundaryLengths3d(piece.mesh.V, piece.boundary));
    if (!outline) {
        return outline.error();
    }
    FlatPiece flat;
    flat.boundarySeconds = boundaryTime.seconds();
    const Stopwatch interiorTime;
    auto points = fillConvex(piece, *outline, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

}  // namespace toile
