// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/outline_targets.h"
#include "core/flatten/base/piece_cloth.h"
#include "core/garment/piece.h"
#include "core/quality/piece_quality.h"

namespace toile {

struct OutlinePlan;

/// One piece after the solver: flat, or the reason for failure.
struct PieceResult {
    std::shared_ptr<const Piece> piece;
    FlattenOptions options;
    OutlineTargets targets{};             ///< target lengths of its outline
    PieceClothPointer cloth{};            ///< as given; only some energies read it
    std::optional<FlatPiece> flat;        ///< points in the plane, before placement on the sheet
    std::optional<PieceQuality> quality;  ///< set if flat
    std::optional<Error> error;           ///< set if not flat
    std::uint64_t fingerprint = 0;        ///< of the flat points; 0 if not flat
    double seconds = 0;
    /// If the outline was drawn differently from how it was solved (pipeline/draw_lines.h): the
    /// result with the exact outline, and the plan. Null: this is the exact one.
    std::shared_ptr<const PieceResult> exact{};
    std::shared_ptr<const OutlinePlan> plan{};
};

/// The result with its outline as solved.
inline const PieceResult& exactOf(const PieceResult& result) {
    return result.exact ? *result.exact : result;
}

/// Whether the user excluded the piece from the pattern: not flat, but no failure.
inline bool isLeftOut(const PieceResult& result) {
    return result.error && result.error->code == ErrorCode::LeftOut;
}

/// "flat", "flipped" (flat, but with flipped triangles), "left-out" or "failed", as in the report.
inline std::string_view statusOf(const PieceResult& result) {
    if (isLeftOut(result)) {
        return "left-out";
    }
    const bool flipped = result.quality && result.quality->flippedTriangles > 0;
    return !result.flat ? "failed" : flipped ? "flipped" : "flat";
}

/// Whether triangles are flipped although the method guarantees that none are.
inline bool breaksPromise(const PieceResult& result) {
    return result.options.method == Method::Isometric && statusOf(result) == "flipped";
}

/// Whether the flat outline crosses itself: the piece cannot be cut out of a single layer.
inline bool crossesItself(const PieceResult& result) {
    return result.quality && result.quality->outlineCrossings > 0;
}

/// Whether it must be replaced by a final result before anything is written.
inline bool isWarm(const PieceResult& result) {
    return result.flat && result.flat->warm;
}

using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

/// The results with their outlines as solved; null if an entry is null.
inline PieceResults exactResults(PieceResults results) {
    for (auto& result : results) {
        result = result && result->exact ? result->exact : result;
    }
    return results;
}

}  // namespace toile
