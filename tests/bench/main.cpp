// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/bench/lowest_times.h"

int main(int argc, char** argv) {
    // Several rounds in turns, so that whatever else the machine does hits all alike. What the user
    // types comes later and wins.
    char repetitions[] = "--benchmark_repetitions=9";
    char interleaving[] = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments(argv, argv + argc);
    arguments.insert(arguments.begin() + 1, {repetitions, interleaving});
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
        return 2;
    }
    toile::bench::LowestTimes times;
    benchmark::RunSpecifiedBenchmarks(&times);
    times.printRatio("toileReader", "plainScan", 2);
    times.printRatio("toileReader", "openMeshReader", 1);
}
