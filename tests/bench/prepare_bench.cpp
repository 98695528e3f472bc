// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to make a sheet of a scan of 58 771 triangles: `prepare/dress_scan/as it is`, and
// `.../remeshed` with its triangles made anew.
#include <optional>
#include <string>

#include "core/prepare/scan.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"

namespace toile::bench {
namespace {

constexpr double kMillimetres = 10;  // the file is in centimetres

const PolygonSoup* scan() {
    static const auto read = [] {
        Progress progress;
        return readSoup(sharedScan(), progress);
    }();
    return read ? &*read : nullptr;
}

void measurePreparing(benchmark::State& state, double edgeLength) {
    if (!scan()) {
        state.SkipWithError("its file is not there");
        return;
    }
    ScanSteps steps;
    steps.edgeLength = edgeLength;
    ScanEffect effect;
    for (auto _ : state) {
        Progress progress;
        effect = prepareScan(*scan(), kMillimetres, steps, progress)->effect;
    }
    if (effect.isRemeshed != (edgeLength > 0)) {
        state.SkipWithError("its triangles could not be made anew");
    }
    state.counters["triangles"] = effect.triangles;
    state.counters["openings"] = effect.openings;
}

void registerOne(const char* name, double edgeLength) {
    auto* added = benchmark::RegisterBenchmark(
        name, [edgeLength](benchmark::State& state) { measurePreparing(state, edgeLength); });
    measured(added, 3)->UseRealTime();
}

}  // namespace

void registerPreparing() {
    registerOne("prepare/dress_scan/kept", 0);
    registerOne("prepare/dress_scan/remeshed-10", 10);
    registerOne("prepare/dress_scan/remeshed-5", 5);
}

}  // namespace toile::bench
