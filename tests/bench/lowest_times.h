// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace toile::bench {

/// Prints the usual table and keeps the processor time of every repetition, so that benchmarks can
/// be compared within one run. The lowest and the middle time are what other programs on the
/// machine disturb least.
class LowestTimes : public benchmark::ConsoleReporter {
public:
    LowestTimes() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override;

    /// One line: how the times of `name` relate to those of `to`, and whether the bound is kept.
    /// Says nothing where one of the two did not run.
    void printRatio(const std::string& name, const std::string& to, double most) const;

private:
    std::map<std::string, std::vector<double>> seconds_;
};

}  // namespace toile::bench
