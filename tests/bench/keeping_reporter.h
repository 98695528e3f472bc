// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <benchmark/benchmark.h>

#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// Keeps the figures of every repetition, so that benchmarks can be compared within one run, and
/// prints a line per benchmark: name, lowest and middle time, counters.
class KeepingReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    const Measurements& measurements() const { return measurements_; }

private:
    Measurements measurements_;
};

}  // namespace toile::bench
