// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/rim_lengths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/garment/piece.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

constexpr double kFirstShare = 0.5;  // of the time, as progress tells it

EdgeLoops allLoops(const Piece& piece) {
    std::vector<std::vector<int>> loops{piece.boundary};
    loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
    return EdgeLoops(loops);
}

bool rimsAreSimple(const Piece& piece, const Points2& Q) {
    return std::ranges::all_of(
        piece.holes, [&](const std::vector<int>& rim) { return outlineIsSimple(Q, rim); });
}

/// Nothing where none is near.
std::optional<DescentResult> descend(const Piece& piece, const Points2& Q, Quality quality,
                                     const Progress& progress) {
    const EdgeLoops loops = allLoops(piece);
    DescentOptions options = descentOptions(quality);
    auto found = lowerIsometricEnergy(piece.mesh, piece.table, loops, Q, options,
                                      Progress(progress, kFirstShare));
    if (found && outlineIsSimple(Q, piece.boundary) && !outlineIsSimple(found->Q, piece.boundary)) {
        options.keepOutlineSimple = true;
        found = lowerIsometricEnergy(piece.mesh, piece.table, loops, Q, options,
                                     Progress(progress, 1 - kFirstShare));
    }
    if (!found || !rimsAreSimple(piece, found->Q)) {
        return std::nullopt;
    }
    return std::move(*found);
}

Error rimsNotKept(const Piece& piece, const Points2& Q) {
    double furthest = 0;
    std::string text;
    for (const auto& rim : piece.holes) {
        const double on = boundaryLengths3d(piece.mesh.V, rim).sum();
        const double flat = boundaryLengths2d(Q, rim).sum();
        if (std::abs(flat - on) >= furthest) {
            furthest = std::abs(flat - on);
            text = fixed(flat, 1) + " mm flat, " + fixed(on, 1) + " mm on the garment";
        }
    }
    return {ErrorCode::RimsNotKept, piece.name, text};
}

}  // namespace

Result<void> keepRimLengths(const Piece& piece, Quality quality, FlatPiece& flat,
                            const Progress& progress) {
    const Stopwatch time;
    auto kept = descend(piece, flat.Q, quality, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    if (!kept) {
        flat.notes.push_back(rimsNotKept(piece, flat.Q));
        return {};
    }
    flat.Q = std::move(kept->Q);
    flat.interiorIterations += kept->iterations;
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds += time.seconds();
    return {};
}

}  // namespace toile
