// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/pipeline/garment_flattener.h"

// For the sources of this folder only.
namespace toile {

/// One piece to flatten, and what is kept of its last flattening, if anything is to be kept; or one
/// that is flat, to draw its outline.
struct PieceTask {
    std::shared_ptr<const Piece> piece;
    std::optional<PieceFlattener> flattener{};
    OutlineTargets targets{};
    /// Null: to flatten. Else the result to draw, by a plan.
    std::shared_ptr<const PieceResult> exact{};
    std::shared_ptr<const OutlinePlan> plan{};
};

struct DoneTask {
    std::shared_ptr<const PieceResult> result;
    std::optional<PieceFlattener> flattener{};  ///< as the flattening left it
};

/// Flattens, or draws, and measures the pieces side by side, as `flattenGarment` promises. A drawn
/// outline that cannot be leaves the exact one, with a note why.
/// @return one per task, in order; after a cancel the unfinished ones carry ErrorCode::Cancelled
///         and no flattener
std::vector<DoneTask> workOn(std::vector<PieceTask> tasks, const FlattenOptions& options,
                             Progress& progress, int threads, OnPiece onPiece = {});

/// How many workers are busy that a cancel has left behind: never more than the machine has cores.
int workersLeftBehind();

}  // namespace toile
