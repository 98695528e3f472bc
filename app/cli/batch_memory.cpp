// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_memory.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

namespace toile::app {
namespace {

constexpr rlim_t kBytesPerMib = rlim_t{1} << 20U;
/// OpenBLAS's buffer for each thread that calls it, and what core/linalg wants free beside.
constexpr rlim_t kBlasBytes = 144 * kBytesPerMib;
constexpr rlim_t kUsualStack = 8 * kBytesPerMib;

/// What this process has already, as RLIMIT_DATA counts it: much is the program's, with which it
/// was born.
rlim_t dataBytes() {
    std::ifstream sizes("/proc/self/statm");  // in pages; the sixth is data and stack
    rlim_t pages = 0;
    for (int field = 0; field < 6; ++field) {
        sizes >> pages;
    }
    return sizes ? pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

rlim_t stackBytes() {
    rlimit stack{};
    getrlimit(RLIMIT_STACK, &stack);
    return stack.rlim_cur == RLIM_INFINITY ? kUsualStack : stack.rlim_cur;
}

void setMemoryLimit(rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace

void limitMemory(int mib, int threads) {
    const auto working = static_cast<rlim_t>(threads);
    const rlim_t stacks = (working + std::thread::hardware_concurrency()) * stackBytes();
    setMemoryLimit(dataBytes() + stacks + working * kBlasBytes +
                   static_cast<rlim_t>(mib) * kBytesPerMib);
}

void liftMemoryLimit() {
    setMemoryLimit(RLIM_INFINITY);
}

}  // namespace toile::app
