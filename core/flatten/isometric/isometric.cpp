// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/progress.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/flatten/isometric/isometric_start.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

/// Energy above which another start may be better: the mean strain exceeds a factor of thirty.
constexpr double kSqueezedStart = 1e3;
/// A descent from warm positions is abandoned after this many steps; most need two to six.
constexpr int kMaxWarmSteps = 15;
/// Vertices from which conjugate gradients cost less than a factorisation if steps are few.
constexpr int kRoundsForFew = 15000;
/// Accuracy of steps by conjugate gradients (`TwoLevelSolver`) that needs as many steps as exact
/// solutions would.
constexpr double kRoughSteps = 0.2;
constexpr int kMaxSteppedApart = 40;  // while the outline is kept simple
/// Crossings per edge of the outline above which no simple outline is near: two sides that cross
/// from end to end have about one crossing per edge.
constexpr int kMaxCrossingsEach = 10;

/// Start of the descent: the conformal result, which is the best start unless it has flips (its
/// energy is infinite then) or triangles squeezed to almost nothing. Otherwise Tutte's embedding on
/// a circle, which cannot have flips, if that is better.
Result<Points2> startOf(const Piece& piece, const OutlineTargets& targets,
                        const isometric::EnergyModel& model, const Points2* conformal,
                        const Progress& progress) {
    const auto energy = model.make(piece.mesh, piece.table);
    const double ofConformal =
        conformal ? energy->energy(*conformal) : std::numeric_limits<double>::infinity();
    if (ofConformal < kSqueezedStart) {
        return *conformal;
    }
    auto circle = tutteOnCircle(piece, progress, targets);
    const bool better = circle && energy->energy(*circle) <= ofConformal;
    const bool cancelled = !circle && circle.error().code == ErrorCode::Cancelled;
    if (conformal && !better && !cancelled) {
        return *conformal;
    }
    return circle;
}

EdgeLoops outlineOf(const Piece& piece, const OutlineTargets& targets) {
    return EdgeLoops(piece.boundary).withLengths(targets.lengths);
}

Result<isometric::DescentResult> descend(const Piece& piece, const OutlineTargets& targets,
                                         const Points2& start,
                                         const isometric::DescentOptions& options,
                                         const Progress& progress) {
    return isometric::lowerIsometricEnergy(piece.mesh, piece.table, outlineOf(piece, targets),
                                           start, options, progress);
}

/// Stores the start for a later edit of this piece.
/// @param simple  positions whose outline does not cross itself, or null
void keep(isometric::DescentResult lowest, const isometric::EnergyModel& energy,
          const Points2* simple, FlatteningMemory& memory) {
    memory.flattened = nullptr;
    memory.Q = memory.simple = nullptr;
    memory.model = nullptr;
    memory.multipliers = nullptr;
    if (!lowest.converged) {
        return;
    }
    memory.flattened = memory.present;
    memory.energy = energy.kind;
    memory.cloth = energy.cloth;
    memory.distortion = lowest.distortion;
    const bool same = simple != nullptr && (simple->array() == lowest.Q.array()).all();
    memory.Q = std::make_shared<const Points2>(std::move(lowest.Q));
    memory.simple = same                ? memory.Q
                    : simple != nullptr ? std::make_shared<const Points2>(*simple)
                                        : nullptr;
    memory.model = std::move(lowest.model);
    memory.multipliers = std::make_shared<const Eigen::VectorXd>(std::move(lowest.multipliers));
}

/// A simple outline with the same lengths, if one is near. After an edit the descent starts from
/// the crossing outline with its sides parted, or from the last one; else from a circle, on a
/// coarse piece first. It keeps the sides apart, and stops if it cannot come near (`wanted`).
std::optional<isometric::DescentResult> uncross(const Piece& piece, const OutlineTargets& targets,
                                                const isometric::DescentResult& crossing,
                                                isometric::DescentOptions options,
                                                const isometric::WarmStart* warm,
                                                const Progress& progress) {
    options.keepOutlineSimple = true;
    options.sharesModel = false;
    options.wanted = isometric::nearLimit(crossing.distortion);
    const auto start = warm != nullptr ? warm->simplePositions(crossing.Q, progress) : std::nullopt;
    if (start) {
        isometric::DescentOptions again = options;
        again.maxIterations = std::min(options.maxIterations, kMaxSteppedApart);
        again.multipliers = crossing.multipliers;
        auto simple = descend(piece, targets, *start, again, progress);
        if (simple && simple->converged &&
            isometric::isNear(simple->distortion, crossing.distortion)) {
            return std::move(*simple);
        }
    }
    const auto circle = tutteOnCircle(piece, progress, targets);
    if (!circle) {
        return std::nullopt;
    }
    auto simple = isometric::lowerFromCoarse(piece.mesh, piece.table, outlineOf(piece, targets),
                                             *circle, options, progress);
    if (!simple || !isometric::isNear(simple->distortion, crossing.distortion)) {
        return std::nullopt;
    }
    return std::move(*simple);
}

double largestStrain(const Piece& piece, const Points2& Q) {
    return edgeStrain(edgeLengths3d(piece.mesh.V, piece.table.edges),
                      edgeLengths2d(Q, piece.table.edges))
        .lpNorm<Eigen::Infinity>();
}

/// After the descent: checks the outline and records the time.
Result<FlatPiece> finish(const Piece& piece, const OutlineTargets& targets,
                         isometric::DescentResult lowest, FlatPiece flat,
                         const isometric::DescentOptions& descent, const isometric::WarmStart* warm,
                         const Stopwatch& time, const Progress& progress,
                         FlatteningMemory* memory) {
    flat.notes.clear();  // notes of the start no longer apply
    if (!lowest.converged) {
        flat.notes.push_back(
            endedEarlyNote(piece, worded("after %1 steps", {figure(lowest.iterations)})));
    }
    flat.interiorIterations = lowest.iterations;
    flat.Q = lowest.Q;
    bool isSimple = true;
    if (const int crossings = outlineCrossings(flat.Q, piece.boundary); crossings > 0) {
        isSimple = false;
        const bool mayBeNear = crossings <= kMaxCrossingsEach * std::ssize(piece.boundary);
        auto simple =
            mayBeNear ? uncross(piece, targets, lowest, descent, warm, progress) : std::nullopt;
        if (simple) {
            flat.notes.push_back(uncrossedNote(piece, crossings));
            flat.interiorIterations += simple->iterations;
            flat.apartStrain = largestStrain(piece, simple->Q) - largestStrain(piece, flat.Q);
            flat.Q = std::move(simple->Q);
            isSimple = outlineIsSimple(flat.Q, piece.boundary);
        }
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    if (memory != nullptr) {
        keep(std::move(lowest), descent.energy, isSimple ? &flat.Q : nullptr, *memory);
    }
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = time.seconds() - flat.boundarySeconds;
    return flat;
}

/// The descent from the positions of an earlier version. Nothing if they are not suitable.
std::optional<isometric::DescentResult> descendWarm(const Piece& piece,
                                                    const OutlineTargets& targets,
                                                    isometric::DescentOptions options,
                                                    const isometric::WarmStart& warm,
                                                    const Progress& progress) {
    std::optional<isometric::IsometricStart> start;
    if (auto Q = warm.positions(progress)) {
        start = isometric::IsometricStart{std::move(*Q), warm.multipliers()};
        options.model = warm.model();
    } else {
        start = warm.fromCoarse(options.tolerance, progress);
        options.sizes.large = kRoundsForFew;
        options.sizes.accuracy = kRoughSteps;
    }
    if (!start) {
        return std::nullopt;
    }
    options.maxIterations = std::min(options.maxIterations, kMaxWarmSteps);
    options.multipliers = std::move(start->multipliers);
    auto lowest = descend(piece, targets, start->Q, options, progress);
    if (!lowest || !lowest->converged) {
        return std::nullopt;
    }
    return std::move(*lowest);
}

/// A copy without positions, notes and times.
FlatPiece figuresOf(const FlatPiece& flat) {
    FlatPiece figures;
    figures.boundarySolver = flat.boundarySolver;
    figures.boundaryIterations = flat.boundaryIterations;
    figures.closureGap = flat.closureGap;
    figures.delaunayFlips = flat.delaunayFlips;
    return figures;
}

/// Without a usable memory: from the conformal result, or the circle.
Result<FlatPiece> descendFromConformal(const Piece& piece, const OutlineTargets& targets,
                                       const FlattenOptions& options,
                                       const isometric::EnergyModel& energy, const Stopwatch& time,
                                       const Progress& progress, FlatteningMemory* memory) {
    isometric::DescentOptions descent = isometric::descentOptions(options.quality, energy);
    descent.sharesModel = memory != nullptr;
    FlattenOptions conformal = options;
    conformal.authalic = 0;
    auto flat = flattenCurvature(piece, conformal, progress, targets);
    if (!flat && (flat.error().code == ErrorCode::Cancelled ||
                  flat.error().code == ErrorCode::NoClosedOutline)) {
        return flat;
    }
    auto start = startOf(piece, targets, energy, flat ? &flat->Q : nullptr, progress);
    if (!start) {
        return start.error();
    }
    if (memory != nullptr) {
        memory->start = flat ? figuresOf(*flat) : FlatPiece{};
    }
    auto lowest = isometric::lowerFromCoarse(piece.mesh, piece.table, outlineOf(piece, targets),
                                             *start, descent, progress);
    if (!lowest && lowest.error().code == ErrorCode::NotFinite && flat) {
        // If a piece is much deeper than its rim is long, even the circle's triangles vanish in
        // rounding. Return the conformal result; its flips are counted.
        flat->notes.push_back(endedEarlyNote(
            piece, worded("Toile found no starting shape without flipped triangles")));
        return flat;
    }
    if (!lowest) {
        return lowest.error();
    }
    return finish(piece, targets, std::move(*lowest), flat ? std::move(*flat) : FlatPiece{},
                  descent, nullptr, time, progress, memory);
}

}  // namespace

Result<FlatPiece> flattenIsometric(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, FlatteningMemory* memory,
                                   const OutlineTargets& targets, const PieceClothPointer& cloth) {
    const Stopwatch time;
    const isometric::EnergyModel energy(options, cloth);
    if (memory != nullptr && memory->Q && memory->energy == energy.kind &&
        isSameCloth(memory->cloth, energy.cloth)) {
        const isometric::WarmStart warm(piece, *memory, targets, energy);
        isometric::DescentOptions descent = isometric::descentOptions(options.quality, energy);
        descent.sharesModel = true;
        auto again = descendWarm(piece, targets, descent, warm, progress);
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        if (again) {
            auto flat = finish(piece, targets, std::move(*again), memory->start, descent, &warm,
                               time, progress, memory);
            if (flat) {
                flat->warm = true;
            }
            return flat;
        }
    }
    return descendFromConformal(piece, targets, options, energy, time, progress, memory);
}

}  // namespace toile
