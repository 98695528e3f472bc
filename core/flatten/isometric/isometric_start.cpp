// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_start.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/isometric_descent.h"

namespace toile::isometric {
namespace {

/// Below this energy the descent is so short that a coarse one saves nothing.
constexpr double kLittleStrain = 1.2;
constexpr int kCoarsestVertices = 200;
constexpr int kStartPasses = 4;
constexpr double kCoarseExcess = 2;

}  // namespace

IsometricStart coarseToFine(const MeshArrays& mesh, const EdgeTable& table,
                            const EdgeLoops& outline, const Points2& Q, const DescentOptions& fine,
                            const Progress& progress) {
    IsometricStart unchanged{Q};
    const auto energy = fine.energy.make(mesh, table);
    const auto vertices = static_cast<int>(mesh.V.rows());
    const int inner = vertices - outline.count();
    const double before = energy->energy(Q);
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
    options.tolerance = fine.tolerance;
    options.energy = fine.energy.onVertices(coarse.kept());
    options.keepOutlineSimple = fine.keepOutlineSimple;
    // A coarse piece strains more than the fine one.
    options.wanted = 1 + kCoarseExcess * (fine.wanted - 1);
    auto lowest = lowerFromCoarse(coarse.mesh(), coarseTable, coarse.loops(), coarse.restricted(Q),
                                  options, progress);
    unchanged.isHopeless = lowest && lowest->isHopeless;
    auto prolonged = lowest ? coarse.prolonged(lowest->Q) : std::nullopt;
    if (!prolonged || !std::isfinite(energy->energy(*prolonged))) {
        return unchanged;
    }
    energy->relax(*prolonged, outline.vertices(), kStartPasses, progress);
    if (!(energy->energy(*prolonged) < before)) {
        return unchanged;
    }
    return {std::move(*prolonged), std::move(lowest->multipliers), lowest->isHopeless};
}

Result<DescentResult> lowerFromCoarse(const MeshArrays& mesh, const EdgeTable& table,
                                      const EdgeLoops& outline, const Points2& Q,
                                      DescentOptions options, const Progress& progress) {
    IsometricStart near = coarseToFine(mesh, table, outline, Q, options, progress);
    if (near.isHopeless) {
        DescentResult hopeless{std::move(near.Q)};
        hopeless.distortion = std::numeric_limits<double>::infinity();
        hopeless.isHopeless = true;
        return hopeless;
    }
    options.multipliers = std::move(near.multipliers);
    return lowerIsometricEnergy(mesh, table, outline, near.Q, options, progress);
}

}  // namespace toile::isometric
