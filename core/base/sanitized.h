// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): names of the sanitizers
void __asan_init() __attribute__((weak));
void __tsan_init() __attribute__((weak));
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
}

namespace toile {

/// Whether a sanitizer is linked in. Checked at run time: the calling code may be compiled without
/// it, and compilers have no common macro.
inline bool isSanitized() {
    return __asan_init != nullptr || __tsan_init != nullptr;
}

}  // namespace toile
