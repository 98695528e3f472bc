// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"

namespace toile {

/// Called when a piece is begun. @param done, count  pieces that are flat by then, of how many
/// Called on the workers, one call at a time, also after a cancel by workers that have not ended
/// yet: it must own everything it uses.
using OnPiece = std::function<void(int done, int count, const Piece& begun)>;

/// Threads of cancelled calls that are still in a stage that cannot be interrupted (a
/// factorisation). They share ownership of their data, end soon, and their results are dropped.
/// The owner of this object decides how long they may run: its destructor waits for them.
/// Thread-safe.
class EndingWorkers {
public:
    void take(std::vector<std::future<void>> more);
    /// How many are still busy and use cores and memory.
    int count() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::future<void>> workers_;  ///< of std::async: their destructors join
};

}  // namespace toile

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
