// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchmarks.h"

namespace toile::bench {

benchmark::internal::Benchmark* measured(benchmark::internal::Benchmark* benchmark,
                                         int repetitions) {
    return benchmark->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->MinTime(0.05)
        ->Repetitions(repetitions);
}

int repetitionsFor(const std::string& piece, const Scope& scope) {
    if (piece.ends_with("/1000000")) {
        return 3;
    }
    if (piece.ends_with("/500000")) {
        return 4;
    }
    return scope.quick ? 5 : 15;
}

}  // namespace toile::bench
