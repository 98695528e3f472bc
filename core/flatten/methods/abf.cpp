// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/abf_angles.h"
#include "core/flatten/conformal_energy.h"
#include "core/flatten/free_boundary.h"
#include "core/flatten/methods/methods.h"

namespace toile {

Result<FlatPiece> flattenAbf(const Piece& piece, const FlattenOptions& /*options*/,
                             const Progress& progress) {
    const Stopwatch time;
    const auto planar = closestPlanarAngles(piece.mesh, piece.boundary, progress);
    if (!planar) {
        return planar.error();
    }
    // Angles that fit are met exactly by a least squares conformal map; where the iteration has not
    // come to its end, they are met as well as can be.
    const ConformalEnergy energy(piece.mesh.F, planar->angles,
                                 static_cast<int>(piece.mesh.V.rows()));
    const auto points = solvePinned(energy, farPairAlongEdges(piece), 1, progress);
    if (!points) {
        return points.error();
    }
    auto flat = atTrueSize(piece, *points, time);
    if (flat) {
        flat->interiorIterations = planar->iterations;
    }
    return flat;
}

}  // namespace toile
