// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace toile::test {

/// Processor time of the work, the least of a few runs, in seconds.
template <class Work>
double quickest(const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

/// How many times as long something takes that is four times as large. For suites named ...Clock,
/// which run at night: a machine that does much else can fail them.
template <class Small, class Large>
double growth(const Small& small, const Large& fourTimesAsLarge) {
    const double least = 1e-3;  // what a clock tells apart
    return quickest(fourTimesAsLarge) / std::max(quickest(small), least);
}

}  // namespace toile::test
