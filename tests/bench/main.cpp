// SPDX-License-Identifier: GPL-3.0-or-later
// All benchmarks. Own options beside Google Benchmark's:
//     --quick          nothing above 45 000 triangles, few repetitions
//     --no-slow-peers  without the peers that take minutes
#include <cstdio>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/bench/benchmarks.h"
#include "tests/bench/keeping_reporter.h"
#include "tests/bench/machine.h"
#include "tests/bench/report/bars.h"

int main(int argc, char** argv) {
    using namespace toile::bench;
    // Several rounds in turns, so that whatever else the machine does hits all alike. What the user
    // types comes later and wins.
    char interleaving[] = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments{argv[0], interleaving};
    Scope scope;
    for (int k = 1; k < argc; ++k) {
        const std::string argument = argv[k];
        if (argument == "--quick") {
            scope.quick = true;
        } else if (argument == "--no-slow-peers") {
            scope.slowPeers = false;
        } else {
            arguments.push_back(argv[k]);
        }
    }
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
        return 2;
    }
    describeMachine();
    registerFloor(scope);
    registerFlattening(scope);
    registerPieces(scope);
    registerReading(scope);
    registerPreparing();
    registerTailor();
    registerWriting(scope);
    registerExport();
    registerGarment(scope);
    registerEndToEnd(scope);
    registerMemory(scope);
    registerResolve(scope);
    registerOutline(scope);
    registerFairing(scope);
    registerAllowances(scope);
    registerPeers(scope);
    KeepingReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\n");
    for (const Bar& bar : barsOf(reporter.measurements())) {
        std::printf("%s\n", line(bar).c_str());
    }
}
