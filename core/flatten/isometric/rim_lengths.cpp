// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/isometric/isometric.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

EdgeLoops allLoops(const Piece& piece, const OutlineTargets& targets) {
    std::vector<std::vector<int>> all{piece.boundary};
    all.insert(all.end(), piece.holes.begin(), piece.holes.end());
    EdgeLoops loops(all);
    Eigen::VectorXd lengths = loops.lengths(piece.mesh.V);
    lengths.head(targets.lengths.size()) = targets.lengths;
    return loops.withLengths(std::move(lengths));
}

bool rimsAreSimple(const Piece& piece, const Points2& Q) {
    return std::ranges::all_of(
        piece.holes, [&](const std::vector<int>& rim) { return outlineIsSimple(Q, rim); });
}

Result<isometric::DescentResult> descend(const Piece& piece, const OutlineTargets& targets,
                                         const Points2& Q, isometric::DescentOptions options,
                                         const Progress& progress) {
    const EdgeLoops loops = allLoops(piece, targets);
    auto found =
        isometric::lowerIsometricEnergy(piece.mesh, piece.table, loops, Q, options, progress);
    const auto isSimple = [&](const Points2& at) -> bool {
        return outlineIsSimple(at, piece.boundary) && rimsAreSimple(piece, at);
    };
    if (found && !isSimple(found->Q) && isSimple(Q)) {
        options.keepOutlineSimple = true;
        if (auto apart = isometric::lowerIsometricEnergy(piece.mesh, piece.table, loops, Q, options,
                                                         progress)) {
            return apart;
        }
    }
    return found;
}

/// The reason to reject the result; empty if there is none.
Wording objection(const Piece& piece, const isometric::EnergyModel& model, const Points2& before,
                  const isometric::DescentResult& kept) {
    if (!rimsAreSimple(piece, kept.Q)) {
        return worded("a rim would cross itself");
    }
    if (!outlineIsSimple(kept.Q, piece.boundary) && outlineIsSimple(before, piece.boundary)) {
        return worded("the outline would cross itself");
    }
    const double energy = model.make(piece.mesh, piece.table)->energy(before);
    return isometric::isNear(kept.distortion, energy) ? Wording()
                                                      : worded("the strain would be too high");
}

}  // namespace

Result<void> keepRimLengths(const Piece& piece, const FlattenOptions& options, FlatPiece& flat,
                            const Progress& progress, const OutlineTargets& targets,
                            const PieceClothPointer& cloth) {
    const Stopwatch time;
    const isometric::EnergyModel energy(options, cloth);
    auto kept = descend(piece, targets, flat.Q, isometric::descentOptions(options.quality, energy),
                        progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    if (!kept && kept.error().code == ErrorCode::OutOfMemory) {
        return kept.error();
    }
    flat.interiorSeconds += time.seconds();
    const Wording against = kept ? objection(piece, energy, flat.Q, *kept) : Wording();
    if (!kept || !against.empty()) {
        flat.notes.push_back(rimsNote(piece, flat.Q, against));
        return {};
    }
    std::erase_if(flat.notes, [](const Error& e) { return e.code == ErrorCode::EndedEarly; });
    if (!kept->converged) {
        flat.notes.push_back(
            endedEarlyNote(piece, worded("after %1 steps", {figure(kept->iterations)})));
    }
    flat.Q = std::move(kept->Q);
    flat.interiorIterations += kept->iterations;
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    return {};
}

}  // namespace toile
