// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/lowest_times.h"

#include <cstdio>

namespace toile::bench {
namespace {

double middleOf(std::vector<double> times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

double lowestOf(const std::vector<double>& times) {
    return *std::min_element(times.begin(), times.end());
}

}  // namespace

void LowestTimes::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
            seconds_[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                           static_cast<double>(run.iterations));
        }
    }
}

void LowestTimes::printRatio(const std::string& name, const std::string& to, double most) const {
    const auto mine = seconds_.find(name), theirs = seconds_.find(to);
    if (mine == seconds_.end() || theirs == seconds_.end()) {
        return;
    }
    const double lowest = lowestOf(mine->second), other = lowestOf(theirs->second);
    std::printf(
        "%s / %s: %.2f at the lowest (%.1f ms / %.1f ms), %.2f in the middle; at most %g: %s\n",
        name.c_str(), to.c_str(), lowest / other, 1e3 * lowest, 1e3 * other,
        middleOf(mine->second) / middleOf(theirs->second), most,
        lowest <= most * other ? "kept" : "NOT kept");
}

}  // namespace toile::bench
