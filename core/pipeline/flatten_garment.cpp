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

Comparison compareMethods(const Garment& garment, std::span<const Method> methods,
                          const FlattenOptions& options, Progress& progress) {
    Comparison comparison;
    const auto count = static_cast<double>(methods.size());
    for (std::size_t k = 0; k < methods.size(); ++k) {
        progress.setShare(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
        FlattenOptions one = options;
        one.method = methods[k];
        comparison.methods.push_back(
            compared(methods[k], garment, flattenGarment(garment, one, progress)));
    }
    return comparison;
}

}  // namespace toile
