// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/pipeline/piece_work.h"
#include "core/pipeline/pipeline.h"

namespace toile {

PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress, int threads) {
    std::vector<PieceTask> tasks;
    for (const auto& piece : garment.pieces) {
        tasks.push_back({piece});
    }
    PieceResults results;
    for (DoneTask& done : workOn(std::move(tasks), options, progress, threads)) {
        results.push_back(std::move(done.result));
    }
    return results;
}

}  // namespace toile
