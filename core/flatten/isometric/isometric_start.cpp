// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_start.h"

#include <cmath>
#include <utility>

#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/flatten/isometric/isometric_descent.h"

namespace toile {
namespace {

/// Below this energy the descent is so short that a coarse one would not shorten it.
constexpr double kLittleStrain = 1.2;
constexpr int kCoarsestVertices = 200;
constexpr int kStartPasses = 4;

}  // namespace

IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const std::vector<int>& boundary, const Points2& Q, double tolerance,
                            const Progress& progress) {
    IsometricStart unchanged{Q, {}};
    const SymmetricDirichlet energy(mesh, table);
    const auto vertices = static_cast<int>(mesh.V.rows());
    const int inner = vertices - static_cast<int>(boundary.size());
    const double before = energy.energy(Q);
    if (before < kLittleStrain || !std::isfinite(before) || inner < kCoarsestVertices) {
        return unchanged;
    }
    const Coarsening coarse(mesh, EdgeLoops(boundary), Q, progress);
    if (!coarse.savesWork() || progress.isCancelled()) {
        return unchanged;
    }
    const EdgeTable coarseTable =
        buildEdgeTable(coarse.mesh().F, static_cast<int>(coarse.mesh().V.rows()));
    IsometricStart start = coarseToFine(coarse.mesh(), coarseTable, coarse.loops().outline(),
                                        coarse.restricted(Q), tolerance, progress);
    DescentOptions options;
    options.tolerance = tolerance;
    options.multipliers = std::move(start.multipliers);
    auto lowest = lowerIsometricEnergy(coarse.mesh(), coarseTable, coarse.loops().outline(),
                                       start.Q, options, progress);
    auto fine = lowest ? coarse.prolonged(lowest->Q) : std::nullopt;
    if (!fine || !std::isfinite(energy.energy(*fine))) {
        return unchanged;
    }
    std::vector<char> fixed(static_cast<std::size_t>(vertices), 0);
    for (const int v : boundary) {
        fixed[v] = 1;
    }
    energy.relax(*fine, fixed, kStartPasses, progress);
    if (!(energy.energy(*fine) < before)) {
        return unchanged;
    }
    return {std::move(*fine), std::move(lowest->multipliers)};
}

}  // namespace toile
