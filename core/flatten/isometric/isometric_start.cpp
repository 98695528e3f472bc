// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_start.h"

#include <cmath>
#include <utility>

#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/flatten/isometric/isometric_descent.h"

namespace toile::isometric {
namespace {

/// Below this energy the descent is so short that a coarse one would not shorten it.
constexpr double kLittleStrain = 1.2;
constexpr int kCoarsestVertices = 200;
constexpr int kStartPasses = 4;

}  // namespace

IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const EdgeLoops& outline, const Points2& Q, double tolerance,
                            const Progress& progress) {
    IsometricStart unchanged{Q, {}};
    const SymmetricDirichlet energy(mesh, table);
    const auto vertices = static_cast<int>(mesh.V.rows());
    const int inner = vertices - outline.count();
    const double before = energy.energy(Q);
    if (before < kLittleStrain || !std::isfinite(before) || inner < kCoarsestVertices) {
        return unchanged;
    }
    const Coarsening coarse(mesh, table, outline, Q, progress);
    if (!coarse.savesWork() || progress.isCancelled()) {
        return unchanged;
    }
    const EdgeTable coarseTable =
        buildEdgeTable(coarse.mesh().F, static_cast<int>(coarse.mesh().V.rows()));
    DescentOptions options;
    options.tolerance = tolerance;
    auto lowest = lowerFromCoarse(coarse.mesh(), coarseTable, coarse.loops(), coarse.restricted(Q),
                                  options, progress);
    auto fine = lowest ? coarse.prolonged(lowest->Q) : std::nullopt;
    if (!fine || !std::isfinite(energy.energy(*fine))) {
        return unchanged;
    }
    energy.relax(*fine, outline.vertices(), kStartPasses, progress);
    if (!(energy.energy(*fine) < before)) {
        return unchanged;
    }
    return {std::move(*fine), std::move(lowest->multipliers)};
}

Result<DescentResult> lowerFromCoarse(const MeshArrays& mesh, const EdgeTable& table,
                                      const EdgeLoops& outline, const Points2& Q,
                                      DescentOptions options, const Progress& progress) {
    IsometricStart near = coarseToFine(mesh, table, outline, Q, options.tolerance, progress);
    options.multipliers = std::move(near.multipliers);
    return lowerIsometricEnergy(mesh, table, outline, near.Q, options, progress);
}

}  // namespace toile::isometric
