// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace toile::test {

/// Processor time of this thread, milliseconds. Other threads and programs do not count.
inline double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace toile::test
