// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/conformal/free_boundary.h"

namespace toile {

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

}  // namespace toile
