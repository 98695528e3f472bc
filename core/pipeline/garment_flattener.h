// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/piece_flattener.h"
#include "core/flatten/piece_result.h"
#include "core/pipeline/pipeline.h"

namespace toile {

/// `flattenGarment` for a garment that is being edited: what the last call found is kept, and only
/// what has changed since is solved again, from what it was.
///
/// A piece that is the same pointer as before, with the same options, gets the same result by
/// pointer. A changed piece goes on from what it was before (`predecessors`; piece_flattener.h says
/// what the result promises after an edit); two pieces that were one both go on from it. Another
/// method begins anew.
///
/// Undo: an older version comes back as one more edit. Who wants its very positions keeps its
/// results, which are immutable, beside the garment that they belong to.
///
/// Thread-safe. Calls may overlap: each begins with what was kept when it began, and the one that
/// ends last is kept. After a cancel the finished pieces are kept, and of the others what was
/// before; a worker left behind changes nothing here.
class GarmentFlattener {
public:
    /// @param mostBytes  kept of all pieces together, meshes and results aside, by an estimate
    ///                   (`PieceFlattener::expectedBytes`). In the garment's order pieces that
    ///                   would go beyond are flattened as `flattenGarment` does, and nothing is
    ///                   kept of them but their results. While a call is on its way what was kept
    ///                   before stays too.
    explicit GarmentFlattener(std::size_t mostBytes = std::size_t{1} << 30U)
        : mostBytes_(mostBytes) {}

    /// As `flattenGarment`, and the same bytes whatever the number of threads, given the same calls
    /// before.
    PieceResults flatten(const Garment& garment, const FlattenOptions& options, Progress& progress,
                         int threads = 0);

    /// Begins anew.
    void forget();

    /// About what is kept now, meshes and results aside.
    std::size_t keptBytes() const;

private:
    struct Kept {
        std::shared_ptr<const PieceResult> result;
        PieceFlattener flattener;
    };

    std::vector<std::shared_ptr<const Kept>> snapshot() const;

    const std::size_t mostBytes_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const Kept>> kept_;  ///< in the order of the last garment
};

}  // namespace toile
