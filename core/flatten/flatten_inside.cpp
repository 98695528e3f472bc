// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/flatten/base/flat_notes.h"
#include "core/flatten/flatten.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/isometric/held_outline.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

bool hasFlips(const Piece& piece, const Points2& Q) {
    return flippedTriangles(triangleAreas2d(Q, piece.mesh.F), triangleAreas3d(piece.mesh)) > 0;
}

bool isConformalInside(Method method) {
    return method == Method::Curvature || method == Method::Wang2005;
}

/// Places the interior like `curvature` and `wang2005`, with holes filled.
Result<Points2> placedInside(const Piece& piece, const Points2& outline, double authalic,
                             const Progress& progress) {
    const Piece filled = piece.holes.empty() ? piece : withHolesFilled(piece);
    Result<Points2> Q = Error{ErrorCode::FactorisationFailed};
    if (authalic != 0) {
        Q = fillInteriorMixed(filled.mesh, filled.table, filled.boundary, outline, authalic,
                              progress);
    } else if (auto interior = ConformalInterior::make(filled, progress)) {
        Q = interior->place(outline, progress);
    } else {
        Q = interior.error();
    }
    if (Q) {
        Q->conservativeResize(piece.mesh.V.rows(), 2);
    }
    return Q;
}

/// The interior by a single linear solve, regardless of flipped triangles.
Result<Points2> linearInside(const Piece& piece, const Points2& Q, const Points2& outline,
                             const FlattenOptions& options, const Progress& progress) {
    if (isConformalInside(options.method)) {
        return placedInside(piece, outline, options.authalic, progress);
    }
    auto moved =
        isometric::harmonicMotion(piece, outline - Q(piece.boundary, Eigen::all), progress);
    if (moved) {
        *moved += Q;
        (*moved)(piece.boundary, Eigen::all) = outline;
    }
    return moved;
}

/// Minimises the energy inside, from a start with the outline at its target. Rims that cannot keep
/// their lengths keep those of the start.
Result<Points2> lowestInside(const Piece& piece, const isometric::EnergyModel& energy,
                             const Points2& start, Quality quality, FlatPiece& flat,
                             const Progress& progress) {
    auto lowest = isometric::lowerInside(piece, energy, start, flat.Q, quality, progress);
    const bool losesRims =
        !lowest && lowest.error().code == ErrorCode::BoundaryNotConverged && !piece.holes.empty();
    if (losesRims) {
        lowest = isometric::lowerInside(piece, energy, start, start, quality, progress);
    }
    if (!lowest) {
        return lowest.error();
    }
    std::erase_if(flat.notes, [&](const Error& note) -> bool {
        return note.code == ErrorCode::EndedEarly ||
               (losesRims && note.code == ErrorCode::RimsNotKept);
    });
    if (losesRims) {
        flat.notes.push_back(rimsNote(piece, lowest->Q, {}));
    }
    if (!lowest->converged) {
        flat.notes.push_back(
            endedEarlyNote(piece, worded("after %1 steps", {figure(lowest->iterations)})));
    }
    return std::move(lowest->Q);
}

/// @param flat  its notes about the end of the iteration are replaced
Result<Points2> solvedInside(const Piece& piece, const Points2& outline,
                             const FlattenOptions& options, const PieceClothPointer& cloth,
                             FlatPiece& flat, const Progress& progress) {
    const bool wasWhole = !hasFlips(piece, flat.Q);
    if (options.method != Method::Isometric || !wasWhole) {
        auto linear = linearInside(piece, flat.Q, outline, options, progress);
        if (!linear || !wasWhole || !hasFlips(piece, *linear)) {
            return linear;
        }
    }
    const isometric::EnergyModel energy(options, cloth);
    auto moved = isometric::outlineMoved(piece, energy, flat.Q, outline, progress);
    const bool isLowered = options.method == Method::Isometric || isConformalInside(options.method);
    return moved && isLowered ? lowestInside(piece, energy, *moved, options.quality, flat, progress)
                              : moved;
}

void renewNotes(const Piece& piece, FlatPiece& flat) {
    std::erase_if(flat.notes, [](const Error& note) -> bool {
        return note.code == ErrorCode::OutlineCrosses || note.code == ErrorCode::TrianglesFlipped ||
               note.code == ErrorCode::DegenerateTriangles;
    });
    flat.crossings = findOutlineCrossings(flat.Q, piece.boundary);
    if (auto note = crossingNote(piece, flat.Q, flat.crossings)) {
        flat.notes.push_back(std::move(*note));
    }
    noteFlips(piece, flat.Q, flat.notes);
    if (auto note = degenerateNote(piece)) {
        flat.notes.push_back(std::move(*note));
    }
}

}  // namespace

Result<FlatPiece> flattenInside(const Piece& piece, const FlatPiece& flat, const Points2& outline,
                                const FlattenOptions& options, const Progress& progress,
                                const PieceClothPointer& cloth) {
    if (piece.defect) {
        return *piece.defect;
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, subjectOf(piece), ""};
    }
    if (!outline.allFinite()) {
        return Error{ErrorCode::NotFinite, subjectOf(piece), "the outline's points"};
    }
    if (outline == flat.Q(piece.boundary, Eigen::all)) {
        return flat;
    }
    if (auto blocked = isometric::blockedBy(piece, flat.Q, outline)) {
        return std::move(*blocked);
    }
    FlatPiece moved = flat;
    auto Q = solvedInside(piece, outline, options, cloth, moved, progress);
    if (!Q || progress.isCancelled()) {
        Error error = Q ? Error{ErrorCode::Cancelled} : Q.error();
        error.subject = subjectOf(piece);
        return error;
    }
    moved.Q = std::move(*Q);
    if (!moved.Q.allFinite()) {
        return Error{ErrorCode::NotFinite, subjectOf(piece), "flat positions"};
    }
    renewNotes(piece, moved);
    return moved;
}

}  // namespace toile
