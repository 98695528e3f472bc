// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
void __asan_init() __attribute__((weak));
void __tsan_init() __attribute__((weak));
}

namespace toile::test {

/// Whether sanitizers look at each step of the library, where the tests themselves are compiled
/// without.
inline bool isSanitized() {
    return __asan_init != nullptr || __tsan_init != nullptr;
}

}  // namespace toile::test
