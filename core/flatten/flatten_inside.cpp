// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/flatten.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/isometric/isometric_descent.h"
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

/// OutlineNotHeld if a triangle rules out the outline for any interior: all its corners are on it,
/// it has an area in Q, and would lose all of it or all but a thousandth. Else nothing.
/// @param outline  #n x 2, mm, of piece.boundary's vertices. Cost: linear.
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

/// The harmonic motion of all vertices for a motion of the outline. Errors: FactorisationFailed,
/// NotFinite, OutOfMemory, Cancelled. Cost: a factorisation of the interior.
Result<Points2> harmonicMotion(const Piece& piece, const Points2& onOutline,
                               const Progress& progress) {
    const auto interior = ConformalInterior::make(piece, progress);
    return interior ? interior->extend(onOutline) : interior.error();
}

/// Moves the outline to given points, bit for bit, and the interior with it; no triangle flips.
/// Moves along the harmonic motion at once, or in stages that end before a triangle loses its area;
/// between stages the energy is lowered a little.
/// @param Q  #V x 2, mm, no flipped triangle
/// Errors: OutlineNotHeld, and those of `harmonicMotion`. Cost: that of `harmonicMotion`, and a
/// factorisation of size 2 #V for each of the few stages if triangles block the way.
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

/// The minimum of the energy with the outline fixed, bit for bit. Rims of holes
/// get the lengths that they have in `flat`.
/// @param start  #V x 2, mm, no flipped triangle
/// @param flat   #V x 2, mm
/// Errors: BoundaryNotConverged (of the rims), OutlineNotHeld, OutOfMemory, Cancelled.
/// Cost: one to three factorisations of size 2 #V. Re-entrant.
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

}  // namespace

}  // namespace toile::isometric

namespace toile {
namespace {

bool hasFlips(const Piece& piece, const Points2& Q) {
    return flippedTriangles(triangleAreas2d(Q, piece.mesh.F), triangleAreas3d(piece.mesh)) > 0;
}

bool isConformalInside(Method method) {
    return method == Method::Curvature || method == Method::Wang2005;
}

/// Places the interior like `curvature` and `wang2005`, with holes filled.
Result<Points2> placedInside(const Piece& piece, const Points2& outline, double authalic,
                             const Progress& progress) {
    const Piece filled = piece.holes.empty() ? piece : withHolesFilled(piece);
    Result<Points2> Q = Error{ErrorCode::FactorisationFailed};
    if (authalic != 0) {
        Q = fillInteriorMixed(filled.mesh, filled.table, filled.boundary, outline, authalic,
                              progress);
    } else if (auto interior = ConformalInterior::make(filled, progress)) {
        Q = interior->place(outline, progress);
    } else {
        Q = interior.error();
    }
    if (Q) {
        Q->conservativeResize(piece.mesh.V.rows(), 2);
    }
    return Q;
}

/// The interior by a single linear solve, regardless of flipped triangles.
Result<Points2> linearInside(const Piece& piece, const Points2& Q, const Points2& outline,
                             const FlattenOptions& options, const Progress& progress) {
    if (isConformalInside(options.method)) {
        return placedInside(piece, outline, options.authalic, progress);
    }
    auto moved =
        isometric::harmonicMotion(piece, outline - Q(piece.boundary, Eigen::all), progress);
    if (moved) {
        *moved += Q;
        (*moved)(piece.boundary, Eigen::all) = outline;
    }
    return moved;
}

/// Minimises the energy inside, from a start with the outline at its target. Rims that cannot keep
/// their lengths keep those of the start.
Result<Points2> lowestInside(const Piece& piece, const isometric::EnergyModel& energy,
                             const Points2& start, Quality quality, FlatPiece& flat,
                             const Progress& progress) {
    auto lowest = isometric::lowerInside(piece, energy, start, flat.Q, quality, progress);
    const bool losesRims =
        !lowest && lowest.error().code == ErrorCode::BoundaryNotConverged && !piece.holes.empty();
    if (losesRims) {
        lowest = isometric::lowerInside(piece, energy, start, start, quality, progress);
    }
    if (!lowest) {
        return lowest.error();
    }
    std::erase_if(flat.notes, [&](const Error& note) -> bool {
        return note.code == ErrorCode::EndedEarly ||
               (losesRims && note.code == ErrorCode::RimsNotKept);
    });
    if (losesRims) {
        flat.notes.push_back(rimsNote(piece, lowest->Q, {}));
    }
    if (!lowest->converged) {
        flat.notes.push_back(
            endedEarlyNote(piece, worded("after %1 steps", {figure(lowest->iterations)})));
    }
    return std::move(lowest->Q);
}

/// @param flat  its notes about the end of the iteration are replaced
Result<Points2> solvedInside(const Piece& piece, const Points2& outline,
                             const FlattenOptions& options, const PieceClothPointer& cloth,
                             FlatPiece& flat, const Progress& progress) {
    const bool wasWhole = !hasFlips(piece, flat.Q);
    if (options.method != Method::Isometric || !wasWhole) {
        auto linear = linearInside(piece, flat.Q, outline, options, progress);
        if (!linear || !wasWhole || !hasFlips(piece, *linear)) {
            return linear;
        }
    }
    const isometric::EnergyModel energy(options, cloth);
    auto moved = isometric::outlineMoved(piece, energy, flat.Q, outline, progress);
    const bool isLowered = options.method == Method::Isometric || isConformalInside(options.method);
    return moved && isLowered ? lowestInside(piece, energy, *moved, options.quality, flat, progress)
                              : moved;
}

void renewNotes(const Piece& piece, FlatPiece& flat) {
    std::erase_if(flat.notes, [](const Error& note) -> bool {
        return note.code == ErrorCode::OutlineCrosses || note.code == ErrorCode::TrianglesFlipped ||
               note.code == ErrorCode::DegenerateTriangles;
    });
    flat.crossings = findOutlineCrossings(flat.Q, piece.boundary);
    if (auto note = crossingNote(piece, flat.Q, flat.crossings)) {
        flat.notes.push_back(std::move(*note));
    }
    noteFlips(piece, flat.Q, flat.notes);
    if (auto note = degenerateNote(piece)) {
        flat.notes.push_back(std::move(*note));
    }
}

}  // namespace

Result<FlatPiece> flattenInside(const Piece& piece, const FlatPiece& flat, const Points2& outline,
                                const FlattenOptions& options, const Progress& progress,
                                const PieceClothPointer& cloth) {
    if (piece.defect) {
        return *piece.defect;
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, subjectOf(piece), ""};
    }
    if (!outline.allFinite()) {
        return Error{ErrorCode::NotFinite, subjectOf(piece), "the outline's points"};
    }
    if (outline == flat.Q(piece.boundary, Eigen::all)) {
        return flat;
    }
    if (auto blocked = isometric::blockedBy(piece, flat.Q, outline)) {
        return std::move(*blocked);
    }
    FlatPiece moved = flat;
    auto Q = solvedInside(piece, outline, options, cloth, moved, progress);
    if (!Q || progress.isCancelled()) {
        Error error = Q ? Error{ErrorCode::Cancelled} : Q.error();
        error.subject = subjectOf(piece);
        return error;
    }
    moved.Q = std::move(*Q);
    if (!moved.Q.allFinite()) {
        return Error{ErrorCode::NotFinite, subjectOf(piece), "flat positions"};
    }
    renewNotes(piece, moved);
    return moved;
}

}  // namespace toile
