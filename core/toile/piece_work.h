// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/toile/garment_flattener.h"

// Internal header of this folder.
namespace toile {

/// One piece to flatten, with the kept state of its last flattening if it is to be kept; or a flat
/// piece whose outline is to be drawn.
struct PieceTask {
    std::shared_ptr<const Piece> piece;
    std::optional<PieceFlattener> flattener{};
    OutlineTargets targets{};
    PieceClothPointer cloth{};
    /// Null: flatten the piece. Else the result to draw by a plan.
    std::shared_ptr<const PieceResult> exact{};
    std::shared_ptr<const OutlinePlan> plan{};
};

struct DoneTask {
    std::shared_ptr<const PieceResult> result;
    std::optional<PieceFlattener> flattener{};  ///< state after the flattening
};

/// Flattens or draws the pieces in parallel and measures them, as `flattenGarment` documents. If an
/// outline cannot be drawn, the exact one stays, with a note.
/// @param ending  gets the threads that are still busy after a cancel, at most one per core; null:
///                the call waits for them
/// @return one per task, in order; after a cancel the unfinished ones carry ErrorCode::Cancelled
///         and no flattener
std::vector<DoneTask> workOn(std::vector<PieceTask> tasks, const FlattenOptions& options,
                             Progress& progress, int threads, EndingWorkers* ending = nullptr,
                             OnPiece onPiece = {});

}  // namespace toile
