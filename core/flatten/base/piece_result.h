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
#include "core/garment/piece.h"
#include "core/quality/piece_quality.h"

namespace toile {

struct OutlinePlan;

/// One piece after the solver: flat, or the reason why not.
struct PieceResult {
    std::shared_ptr<const Piece> piece;
    FlattenOptions options;
    OutlineTargets targets{};             ///< what its outline is to measure
    std::optional<FlatPiece> flat;        ///< points in the plane, before the sheet places them
    std::optional<PieceQuality> quality;  ///< there where flat is
    std::optional<Error> error;           ///< there where flat is not
    std::uint64_t fingerprint = 0;        ///< of the flat points; 0 where not flat
    double seconds = 0;
    /// Where the outline was drawn otherwise than it was solved (pipeline/draw_lines.h): the result
    /// with the exact outline, and by what it was drawn. Null: this is the exact one.
    std::shared_ptr<const PieceResult> exact{};
    std::shared_ptr<const OutlinePlan> plan{};
};

/// The result with its outline as it was solved.
inline const PieceResult& exactOf(const PieceResult& result) {
    return result.exact ? *result.exact : result;
}

/// Whether a person does not want the piece in the pattern: not flat, and no failure.
inline bool isLeftOut(const PieceResult& result) {
    return result.error && result.error->code == ErrorCode::LeftOut;
}

/// "flat", "flipped" (flat, but triangles are flipped), "left-out" or "failed": the report's words.
inline std::string_view statusOf(const PieceResult& result) {
    if (isLeftOut(result)) {
        return "left-out";
    }
    const bool flipped = result.quality && result.quality->flippedTriangles > 0;
    return !result.flat ? "failed" : flipped ? "flipped" : "flat";
}

/// Whether triangles are flipped although the method promises that none does.
inline bool breaksPromise(const PieceResult& result) {
    return result.options.method == Method::Isometric && statusOf(result) == "flipped";
}

/// Whether the flat outline crosses itself: the piece cannot be cut out of one layer of cloth.
inline bool crossesItself(const PieceResult& result) {
    return result.quality && result.quality->outlineCrossings > 0;
}

/// Whether another result is to take its place before anything is written.
inline bool isWarm(const PieceResult& result) {
    return result.flat && result.flat->warm;
}

using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

/// The results with their outlines as they were solved; null where one is.
inline PieceResults exactResults(PieceResults results) {
    for (auto& result : results) {
        result = result && result->exact ? result->exact : result;
    }
    return results;
}

}  // namespace toile
