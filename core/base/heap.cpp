// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/heap.h"

#ifdef __GLIBC__
#include <limits>

#include <malloc.h>
#endif

namespace toile {

void keepFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace toile
