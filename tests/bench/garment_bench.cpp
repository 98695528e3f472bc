// SPDX-License-Identifier: GPL-3.0-or-later
// A garment's pieces side by side: the same bytes on one thread and on two, in less time.
#include <string>

#include "core/formats/writers.h"
#include "core/toile/garment_flattener.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/core/support/laid_rows.h"

namespace toile::bench {
namespace {

const Garment* dress() {
    static const auto garment = [] {
        Progress progress;
        return loadGarment({sharedFile("dress")}, {}, progress);
    }();
    return garment ? &*garment : nullptr;
}

std::string bytesOf(const Garment& garment, const PieceResults& results) {
    return writeObj(garment, results, inRows(garment, results).marker);
}

void measureGarment(benchmark::State& state, int threads) {
    const Garment* garment = dress();
    if (garment == nullptr) {
        state.SkipWithError("its file is not there");
        return;
    }
    PieceResults results;
    for (auto _ : state) {
        Progress progress;
        results = flattenGarment(*garment, {}, progress, threads);
    }
    static const std::string first = bytesOf(*garment, results);
    if (bytesOf(*garment, results) != first) {
        state.SkipWithError("the bytes depend on the number of threads");
    }
}

/// A garment flattened again although nothing has changed.
void measureUnchanged(benchmark::State& state, bool knowing) {
    const Garment* garment = dress();
    if (garment == nullptr) {
        state.SkipWithError("its file is not there");
        return;
    }
    GarmentFlattener flattener;
    if (knowing) {
        Progress progress;
        flattener.flatten(*garment, {}, progress, 1);
    }
    for (auto _ : state) {
        Progress progress;
        benchmark::DoNotOptimize(flattener.flatten(*garment, {}, progress, 1));
        if (!knowing) {
            flattener.reset();
        }
    }
}

}  // namespace

void registerGarment(const Scope& scope) {
    for (const int threads : {1, 2}) {
        auto* added = benchmark::RegisterBenchmark(
            ("garment/dress/threads-" + std::to_string(threads)).c_str(),
            [threads](benchmark::State& state) { measureGarment(state, threads); });
        measured(added, scope.quick ? 3 : 9)->UseRealTime();
    }
    for (const auto& [name, knowing] :
         {std::pair("resolveUnchanged/dress", true), std::pair("coldUnchanged/dress", false)}) {
        auto* added = benchmark::RegisterBenchmark(
            name,
            [knowing = knowing](benchmark::State& state) { measureUnchanged(state, knowing); });
        measured(added, 3);
    }
}

}  // namespace toile::bench
