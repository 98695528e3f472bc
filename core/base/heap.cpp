// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/heap.h"

#include <atomic>

#ifdef __GLIBC__
#include <limits>

#include <malloc.h>
#endif

namespace toile {
namespace {

std::atomic<bool> isKept{false};

}  // namespace

void keepFreedMemory() {
    isKept = true;
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void returnFreedMemory() {
#ifdef __GLIBC__
    if (!isKept) {
        malloc_trim(0);
    }
#endif
}

}  // namespace toile
