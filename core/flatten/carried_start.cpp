// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/carried_start.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/flatten/conformal_interior.h"
#include "core/flatten/dirichlet_energy.h"
#include "core/flatten/flattening_memory.h"
#include "core/flatten/length_constraints.h"
#include "core/flatten/match_versions.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Motion of the outline, in parts of its mean edge, that the interior need not follow.
constexpr double kStill = 1e-9;
/// Energy above 1 up to which a start is taken: so many times that before the edit, or so much. An
/// edit that folds or squeezes the carried positions makes the way down longer than the usual one.
constexpr double kMostGrowth = 2;
constexpr double kSlightExcess = 0.05;
/// And never from here on: the mean strain is beyond thirtyfold.
constexpr double kSqueezed = 1e3;

double mostEnergy(double before) {
    return std::min(kSqueezed, 1 + std::max(kSlightExcess, kMostGrowth * (before - 1)));
}

/// The interior follows the outline's motion harmonically, by the memory's factor where it suits.
std::optional<Points2> following(const Piece& piece, const Points2& carried, const Points2& outline,
                                 FlatteningMemory& memory, const Progress& progress) {
    auto interior = ConformalInterior::make(piece, progress, &memory);
    if (!interior) {
        return std::nullopt;
    }
    Eigen::MatrixXd motion(static_cast<Eigen::Index>(piece.boundary.size()), 2);
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        const int v = piece.boundary[i];
        motion.row(static_cast<Eigen::Index>(i)) = outline.row(v) - carried.row(v);
    }
    const auto followed = interior->extend(motion, progress);
    if (!followed) {
        return std::nullopt;
    }
    Points2 moved = carried + *followed;
    for (const int v : piece.boundary) {
        moved.row(v) = outline.row(v);  // to the last digit
    }
    return moved;
}

}  // namespace

std::optional<Points2> carriedStart(const Piece& piece, FlatteningMemory& memory,
                                    const Progress& progress) {
    const VersionMatch match = matchVersions(piece, *memory.flattened);
    auto carried = carriedOver(match, *memory.flattened, *memory.Q);
    if (!carried || progress.isCancelled()) {
        return std::nullopt;
    }
    const Eigen::VectorXd lengths = boundaryLengths3d(piece.mesh.V, piece.boundary);
    Points2 start = *carried;
    if (!LengthConstraints(piece.boundary, lengths).restore(start)) {
        return std::nullopt;
    }
    // Mostly it is better where the interior follows; where the outline moves far against the size
    // of its triangles it may fold there, and not where it stays.
    if (progress.isCancelled()) {
        return std::nullopt;
    }
    const SymmetricDirichlet energy(piece.mesh, piece.table);
    double least = energy.energy(start);
    if ((start - *carried).lpNorm<Eigen::Infinity>() > kStill * lengths.mean()) {
        auto moved = following(piece, *carried, start, memory, progress);
        if (const double other = moved ? energy.energy(*moved) : least; other < least) {
            start = std::move(*moved);
            least = other;
        }
    }
    if (!(least < mostEnergy(memory.distortion)) || progress.isCancelled()) {
        return std::nullopt;
    }
    return start;
}

}  // namespace toile
