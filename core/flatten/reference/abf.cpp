// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/conformal/free_boundary.h"
#include "core/flatten/reference/abf_angles.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/piece.h"

namespace toile {
namespace {

constexpr double kUnmet = 1e-6;  // radians: more than this can be seen in the map

}  // namespace

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
        if (planar->residual > kUnmet) {
            flat->notes.push_back(endedEarlyNote(
                piece, worded("angles that fit in the plane are met to %1 radians only",
                              {shortest(planar->residual)})));
        }
    }
    return flat;
}

}  // namespace toile
