// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/keeping_reporter.h"

#include <cstdio>
#include <iostream>
#include <map>
#include <string>

#include "tests/bench/report/figures.h"

namespace toile::bench {
namespace {

void print(const std::string& name, const Measurement& measurement) {
    std::printf("%-45s %10s ms, middle %10s ms", name.c_str(),
                milliseconds(measurement.lowest()).c_str(),
                milliseconds(measurement.median()).c_str());
    for (const auto& [key, value] : measurement.counters) {
        std::printf("  %s %s", key.c_str(), significant(value).c_str());
    }
    std::printf("\n");
    std::fflush(stdout);  // the next one may take minutes
}

}  // namespace

bool KeepingReporter::ReportContext(const Context& context) {
    PrintBasicContext(&std::cerr, context);
    return true;
}

void KeepingReporter::ReportRuns(const std::vector<Run>& runs) {
    std::string name;
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) {
            continue;
        }
        if (run.error_occurred) {
            std::printf("%-45s skipped: %s\n", plainName(run.benchmark_name()).c_str(),
                        run.error_message.c_str());
            continue;
        }
        const auto iterations = static_cast<double>(run.iterations);
        std::map<std::string, double> counters;
        for (const auto& [key, counter] : run.counters) {
            counters[key] = counter.value;
        }
        name = run.benchmark_name();
        measurements_.add(name, run.cpu_accumulated_time / iterations,
                          run.real_accumulated_time / iterations, counters);
    }
    if (!name.empty()) {
        print(plainName(name), *measurements_.find(plainName(name)));
    }
}

}  // namespace toile::bench
