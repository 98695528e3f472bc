// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/draw_lines.h"

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/pattern/drawn_outline.h"
#include "core/toile/piece_work.h"

namespace toile {

PieceResults drawLines(const Garment& garment, PieceResults exact, const LineSettings& settings,
                       const Symmetry* symmetry, const PieceResults& known, Progress& progress,
                       int threads, EndingWorkers* ending) {
    if (!draws(settings) || progress.isCancelled()) {
        return exact;
    }
    const auto plans = planOutlines(garment, exact, settings, symmetry);
    std::unordered_map<const PieceResult*, std::shared_ptr<const PieceResult>> drawn;
    for (const auto& result : known) {
        if (result && result->exact && result->flat) {
            drawn.emplace(result->exact.get(), result);
        }
    }
    std::vector<PieceTask> tasks;
    std::vector<std::size_t> place;  // of each task
    for (std::size_t p = 0; p < exact.size(); ++p) {
        if (!plans[p]) {
            continue;
        }
        const auto same = drawn.find(exact[p].get());
        if (same != drawn.end() && *same->second->plan == *plans[p]) {
            exact[p] = same->second;
            continue;
        }
        tasks.push_back(
            {exact[p]->piece, {}, exact[p]->targets, exact[p]->cloth, exact[p], plans[p]});
        place.push_back(p);
    }
    if (tasks.empty()) {
        return exact;
    }
    const FlattenOptions options = tasks.front().exact->options;
    std::vector<DoneTask> done = workOn(std::move(tasks), options, progress, threads, ending);
    for (std::size_t t = 0; t < done.size(); ++t) {
        exact[place[t]] = std::move(done[t].result);
    }
    return exact;
}

}  // namespace toile
