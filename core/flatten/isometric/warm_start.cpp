// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/isometric.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/flatten/isometric/isometric_start.h"
#include "core/flatten/isometric/outline_terms.h"
#include "core/garment/garment.h"
#include "core/garment/piece.h"
#include "core/quality/outline_crossings.h"

namespace toile::isometric {
namespace {

/// Motion of the outline, relative to its mean edge, that the interior need not follow.
constexpr double kStill = 1e-9;
/// Maximum excess of a start's energy over 1: a multiple of that before the edit, or a constant.
/// From positions that an edit folds or squeezes the descent would take longer than usual.
constexpr double kMaxGrowth = 2;
constexpr double kSlightExcess = 0.05;
/// Never above this energy: the mean strain exceeds a factor of thirty.
constexpr double kSqueezed = 1e3;

/// Gap between two parted sides, relative to the barrier's radius.
constexpr double kGap = 0.7;
constexpr int kMaxPartings = 5;
constexpr int kWarmPasses = 4;
/// Share of the vertices that a small edit leaves at their place in space.
constexpr double kMinStay = 0.9;
/// Of a coarse piece: minimum number of vertices, and factor of the tolerance.
constexpr int kFewVertices = 200;
constexpr double kCoarseTolerance = 3;
/// Relative change of an edge's length from which moving the outline alone folds.
constexpr double kFarLength = 0.5;

double mostEnergy(double before) {
    return std::min(kSqueezed, 1 + std::max(kSlightExcess, kMaxGrowth * (before - 1)));
}

/// The interior follows the outline's motion harmonically.
std::optional<Points2> following(const Piece& piece, const Points2& warm, const Points2& outline,
                                 const Progress& progress) {
    const auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return std::nullopt;
    }
    const Points2 motion = outline - warm;
    const auto followed = interior->extend(motion(piece.boundary, Eigen::all));
    if (!followed) {
        return std::nullopt;
    }
    Points2 moved = warm + *followed;
    moved(piece.boundary, Eigen::all) = outline(piece.boundary, Eigen::all);  // bit for bit
    return moved;
}

/// Parts the two sides of cuts. Restoring the lengths undoes some of it, so this is repeated.
/// @return false if the outline still crosses or touches itself
bool partedWithLengths(const Piece& piece, const LengthConstraints& constraints,
                       const Eigen::VectorXd& lengths, Points2& Q) {
    const Eigen::VectorXd gap = kGap * OutlineBarrier(piece.boundary, lengths).radius();
    for (int k = 0; k < kMaxPartings; ++k) {
        partCutSides(piece, gap, Q);
        if (!constraints.restore(Q)) {
            return false;
        }
        if (outlineIsSimple(Q, piece.boundary)) {
            return true;
        }
    }
    return false;
}

/// Per boundary vertex the loop index of its mate, or -1.
std::vector<int> mates(const Piece& piece) {
    const auto n = static_cast<int>(piece.boundary.size());
    const auto placeOf = [&](int i) {
        const auto at = piece.mesh.V.row(piece.boundary[i]);
        return std::tuple(at.x(), at.y(), at.z());
    };
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) -> bool {
        return std::tuple(placeOf(a), a) < std::tuple(placeOf(b), b);
    });
    std::vector<int> mate(static_cast<std::size_t>(n), -1);
    for (int first = 0, last = 0; first < n; first = last) {
        for (last = first + 1; last < n && placeOf(order[last]) == placeOf(order[first]);) {
            ++last;
        }
        if (last - first == 2) {
            mate[order[first]] = order[first + 1];
            mate[order[first + 1]] = order[first];
        }
    }
    return mate;
}

}  // namespace

WarmStart::WarmStart(const Piece& piece, const FlatteningMemory& memory, OutlineTargets targets,
                     EnergyModel energy)
    : piece_(piece),
      memory_(memory),
      targets_(std::move(targets)),
      energy_(std::move(energy)),
      match_(matchVersions(piece, *memory.flattened)) {}

std::optional<Points2> WarmStart::positions(const Progress& progress) const {
    auto start = startFrom(*memory_.Q, false, progress);
    if (!start && memory_.simple && memory_.simple != memory_.Q) {
        start = startFrom(*memory_.simple, false, progress);
    }
    return start;
}

std::optional<Points2> WarmStart::simplePositions(const Points2& crossing,
                                                  const Progress& progress) const {
    auto parted = fitted(crossing, true, progress);
    if (parted || !memory_.simple) {
        return parted;
    }
    return startFrom(*memory_.simple, true, progress);
}

std::optional<Points2> WarmStart::startFrom(const Points2& before, bool apart,
                                            const Progress& progress) const {
    const auto warm = carriedOver(match_, *memory_.flattened, before);
    return warm ? fitted(*warm, apart, progress) : std::nullopt;
}

std::optional<Points2> WarmStart::fitted(const Points2& warm, bool apart,
                                         const Progress& progress) const {
    if (progress.isCancelled()) {
        return std::nullopt;
    }
    const Eigen::VectorXd lengths = outlineLengths(piece_, targets_);
    const LengthConstraints constraints(piece_.boundary, lengths);
    if (constraints.residual(warm).cwiseQuotient(lengths).lpNorm<Eigen::Infinity>() > kFarLength) {
        return std::nullopt;
    }
    Points2 start = warm;
    if (!(apart ? partedWithLengths(piece_, constraints, lengths, start)
                : constraints.restore(start))) {
        return std::nullopt;
    }
    // Usually the result is better if the interior follows. If the outline moves far relative to
    // its triangles, following may fold, while staying does not.
    if (progress.isCancelled()) {
        return std::nullopt;
    }
    const auto energy = energy_.make(piece_.mesh, piece_.table);
    double least = energy->energy(start);
    if ((start - warm).lpNorm<Eigen::Infinity>() > kStill * lengths.mean()) {
        auto moved = following(piece_, warm, start, progress);
        if (const double other = moved ? energy->energy(*moved) : least; other < least) {
            start = std::move(*moved);
            least = other;
        }
    }
    if (!(least < mostEnergy(memory_.distortion)) || progress.isCancelled()) {
        return std::nullopt;
    }
    energy->relax(start, piece_.boundary, kWarmPasses, progress);
    return start;
}

std::optional<IsometricStart> WarmStart::fromCoarse(double tolerance,
                                                    const Progress& progress) const {
    const auto warm = carriedOver(match_, *memory_.flattened, *memory_.Q);
    if (!warm || piece_.mesh.V.rows() < kFewVertices || !isSmallEdit() || progress.isCancelled()) {
        return std::nullopt;
    }
    const Coarsening coarsening(piece_.mesh, piece_.table,
                                EdgeLoops(piece_.boundary).withLengths(targets_.lengths), *warm,
                                progress);
    if (!coarsening.savesWork() || progress.isCancelled()) {
        return std::nullopt;
    }
    Piece coarse = makePiece(piece_.name, coarsening.mesh());
    coarse.boundary = coarsening.loops().outline();
    if (coarse.defect) {
        return std::nullopt;
    }
    const auto flat = flattenCurvature(coarse, FlattenOptions(), progress, targets_);
    // A coarser tolerance is enough: the fine descent refines the result.
    DescentOptions options;
    options.energy = energy_.onVertices(coarsening.kept());
    if (!flat || !(options.energy.make(coarse.mesh, coarse.table)->energy(flat->Q) < kSqueezed)) {
        return std::nullopt;
    }
    options.tolerance = kCoarseTolerance * tolerance;
    auto lowest =
        lowerFromCoarse(coarse.mesh, coarse.table, coarsening.loops(), flat->Q, options, progress);
    auto fine = lowest ? coarsening.followed(*warm, lowest->Q) : std::nullopt;
    if (!fine || progress.isCancelled()) {
        return std::nullopt;
    }
    energy_.make(piece_.mesh, piece_.table)->relax(*fine, piece_.boundary, kWarmPasses, progress);
    return IsometricStart{std::move(*fine), std::move(lowest->multipliers)};
}

bool WarmStart::isSmallEdit() const {
    const Points3& before = memory_.flattened->mesh.V;
    int stay = 0;
    for (std::size_t v = 0; v < match_.vertex.size(); ++v) {
        const int was = match_.vertex[v];
        stay += was >= 0 && piece_.mesh.V.row(static_cast<Eigen::Index>(v)) == before.row(was);
    }
    return stay >= kMinStay * static_cast<double>(match_.vertex.size());
}

Eigen::VectorXd WarmStart::multipliers() const {
    const std::vector<int>& boundary = piece_.boundary;
    const std::vector<int>& before = memory_.flattened->boundary;
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(boundary.size()));
    std::vector<int> place(static_cast<std::size_t>(memory_.flattened->mesh.V.rows()), -1);
    for (std::size_t i = 0; i < before.size(); ++i) {
        place[before[i]] = static_cast<int>(i);
    }
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const int v = match_.vertex[boundary[i]];
        const int w = match_.vertex[boundary[(i + 1) % boundary.size()]];
        const int at = v >= 0 ? place[v] : -1;
        if (w >= 0 && at >= 0 && before[(static_cast<std::size_t>(at) + 1) % before.size()] == w) {
            multipliers[static_cast<Eigen::Index>(i)] = (*memory_.multipliers)[at];
        }
    }
    return multipliers;
}

std::shared_ptr<const KktModel> WarmStart::model() const {
    const Piece& before = *memory_.flattened;
    const bool same = piece_.mesh.V.rows() == before.mesh.V.rows() &&
                      piece_.mesh.F.rows() == before.mesh.F.rows() &&
                      piece_.boundary == before.boundary &&
                      (piece_.mesh.F.array() == before.mesh.F.array()).all();
    return same ? memory_.model : nullptr;
}

void partCutSides(const Piece& piece, const Eigen::VectorXd& gap, Points2& Q) {
    const auto n = static_cast<int>(piece.boundary.size());
    const std::vector<int> mate = mates(piece);
    const Points2 before = Q;
    const auto at = [&](int i) -> Eigen::RowVector2d { return before.row(piece.boundary[i]); };
    const auto inwards = [&](int i) -> Eigen::RowVector2d {
        const Eigen::RowVector2d along = at((i + 1) % n) - at((i + n - 1) % n);
        return Eigen::RowVector2d(-along.y(), along.x()).normalized();
    };
    for (int i = 0; i < n; ++i) {
        if (mate[i] < 0) {
            continue;
        }
        const Eigen::RowVector2d across = (inwards(i) - inwards(mate[i])).normalized();
        const double missing = gap[i] - (at(i) - at(mate[i])).dot(across);
        if (missing > 0 && across.allFinite()) {
            Q.row(piece.boundary[i]) += 0.5 * missing * across;
        }
    }
}

}  // namespace toile::isometric
