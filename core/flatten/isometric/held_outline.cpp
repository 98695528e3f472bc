// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/held_outline.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile::isometric {
namespace {

/// Share of the way to the first triangle without area.
constexpr double kOfTheWay = 0.9;
constexpr int kMaxStages = 20;
/// Descent steps between two stages: enough to make room for the next stage.
constexpr int kStepsForRoom = 3;
/// Minimum share of its area that a triangle keeps on a straightened outline. A smaller triangle
/// looks like a line and dominates the energy.
constexpr double kMinKept = 1e-3;

/// All loops: the outline fixed where it is in Q, rims with the lengths that they have in `rims`.
EdgeLoops heldLoops(const Piece& piece, const Points2& Q, const Points2& rims) {
    std::vector<std::vector<int>> all{piece.boundary};
    all.insert(all.end(), piece.holes.begin(), piece.holes.end());
    const EdgeLoops loops(all);
    Eigen::VectorXd lengths(loops.count());
    for (int i = 0; i < loops.count(); ++i) {
        const Points2& from = i < loops.start(1) ? Q : rims;
        lengths[i] = (from.row(loops.end(i)) - from.row(loops.vertex(i))).norm();
    }
    return loops.withLengths(std::move(lengths)).withOutlineHeld();
}

/// Lowers the energy of the interior by a few descent steps; the outline stays.
void makeRoom(const Piece& piece, const EnergyModel& energy, Points2& Q, const Progress& progress) {
    DescentOptions options = descentOptions(Quality::Draft, energy);
    options.maxIterations = kStepsForRoom;
    auto lower =
        lowerIsometricEnergy(piece.mesh, piece.table, heldLoops(piece, Q, Q), Q, options, progress);
    if (lower) {
        lower->Q(piece.boundary, Eigen::all) = Q(piece.boundary, Eigen::all).eval();
        Q = std::move(lower->Q);
    }
}

Wording placeOf(const Piece& piece, Eigen::Index face) {
    const Eigen::RowVector3d at = piece.mesh.V(piece.mesh.F.row(face), Eigen::all).colwise().mean();
    return placeWording(at.x(), at.y(), at.z());
}

/// Reports the triangle that is flipped or collapsed the most.
Error noWay(const Piece& piece, const Points2& Q) {
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    const Eigen::Index worst = worstFlipped(areas, triangleAreas3d(piece.mesh));
    const Wording place = placeOf(piece, worst);
    return {ErrorCode::OutlineNotHeld, subjectOf(piece),
            areas[worst] < 0
                ? toile::worded("the triangle at %1 mm would turn over", {place})
                : toile::worded("the triangle at %1 mm would have no area left", {place})};
}

Wording blockedAt(const Piece& piece, Eigen::Index face, bool turnsOver) {
    const Wording place = placeOf(piece, face);
    return turnsOver ? toile::worded(
                           "the triangle at %1 mm, all its corners on the outline, "
                           "would turn over",
                           {place})
                     : toile::worded(
                           "the triangle at %1 mm, all its corners on the outline, "
                           "would have no area left",
                           {place});
}

}  // namespace

std::optional<Error> blockedBy(const Piece& piece, const Points2& Q, const Points2& outline) {
    Points2 moved = Q;
    moved(piece.boundary, Eigen::all) = outline;
    std::vector<char> onOutline(static_cast<std::size_t>(Q.rows()), 0);
    for (const int v : piece.boundary) {
        onOutline[v] = 1;
    }
    const Eigen::VectorXd before = triangleAreas2d(Q, piece.mesh.F);
    const Eigen::VectorXd after = triangleAreas2d(moved, piece.mesh.F);
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        const auto corner = piece.mesh.F.row(f);
        const bool isHeld = onOutline[corner[0]] + onOutline[corner[1]] + onOutline[corner[2]] == 3;
        if (isHeld && before[f] > 0 && !(after[f] > kMinKept * before[f])) {
            return Error{ErrorCode::OutlineNotHeld, subjectOf(piece),
                         blockedAt(piece, f, after[f] < 0)};
        }
    }
    return std::nullopt;
}

Result<Points2> harmonicMotion(const Piece& piece, const Points2& onOutline,
                               const Progress& progress) {
    const auto interior = ConformalInterior::make(piece, progress);
    return interior ? interior->extend(onOutline) : interior.error();
}

Result<Points2> outlineMoved(const Piece& piece, const EnergyModel& model, Points2 Q,
                             const Points2& outline, const Progress& progress) {
    const auto motion = harmonicMotion(piece, outline - Q(piece.boundary, Eigen::all), progress);
    if (!motion) {
        return motion.error();
    }
    const auto energy = model.make(piece.mesh, piece.table);
    double left = 1;
    for (int stage = 0; stage < kMaxStages && !progress.isCancelled(); ++stage) {
        const double free = energy->largestStep(Q, *motion, left / kOfTheWay);
        if (!(free < left / kOfTheWay)) {
            Q += left * *motion;
            Q(piece.boundary, Eigen::all) = outline;
            return std::isfinite(energy->energy(Q)) ? Result<Points2>(std::move(Q))
                                                    : noWay(piece, Q);
        }
        Q += kOfTheWay * free * *motion;
        left -= kOfTheWay * free;
        makeRoom(piece, model, Q, progress);
        progress.step();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return noWay(piece, Q + left * *motion);
}

Result<DescentResult> lowerInside(const Piece& piece, const EnergyModel& energy,
                                  const Points2& start, const Points2& flat, Quality quality,
                                  const Progress& progress) {
    auto lowest = lowerIsometricEnergy(piece.mesh, piece.table, heldLoops(piece, start, flat),
                                       start, descentOptions(quality, energy), progress);
    if (!lowest) {
        return lowest;
    }
    // Restoring the lengths of rims may have moved the outline by rounding.
    lowest->Q(piece.boundary, Eigen::all) = start(piece.boundary, Eigen::all);
    if (flippedTriangles(triangleAreas2d(lowest->Q, piece.mesh.F), triangleAreas3d(piece.mesh)) >
        0) {
        return noWay(piece, lowest->Q);
    }
    return lowest;
}

}  // namespace toile::isometric
