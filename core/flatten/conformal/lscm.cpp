// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/conformal/free_boundary.h"

namespace toile {

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

}  // namespace toile
