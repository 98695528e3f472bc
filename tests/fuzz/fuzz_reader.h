// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/check_reader.h"

namespace toile::fuzz {

/// The body of every target: gives the fuzzer's bytes to a reader and stops where a promise breaks.
/// @return 0, as libFuzzer wants it
template <ReadFunction reader>
int fuzzReader(const std::uint8_t* data, std::size_t size) {
    const std::string broken =
        whatBreaks(reader, std::string(reinterpret_cast<const char*>(data), size));
    if (!broken.empty()) {
        std::fprintf(stderr, "Broken promise: %s\n", broken.c_str());
        std::abort();
    }
    return 0;
}

}  // namespace toile::fuzz
