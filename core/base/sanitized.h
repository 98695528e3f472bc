// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): theirs
void __asan_init() __attribute__((weak));
void __tsan_init() __attribute__((weak));
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
}

namespace toile {

/// Whether sanitizers look at each step of the library: by what is linked, as whoever asks may be
/// compiled without, and compilers do not agree on a macro that says so.
inline bool isSanitized() {
    return __asan_init != nullptr || __tsan_init != nullptr;
}

}  // namespace toile
