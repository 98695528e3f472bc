// SPDX-License-Identifier: GPL-3.0-or-later
// The program of every fuzz target; TOILE_FUZZ_TARGET is its name.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto target = std::ranges::find(
        toile::fuzz::targets(), std::string_view(TOILE_FUZZ_TARGET), &toile::fuzz::Target::name);
    const std::string broken = target->whatBreaks({reinterpret_cast<const char*>(data), size});
    if (!broken.empty()) {
        std::fprintf(stderr, "Broken promise: %s\n", broken.c_str());
        std::abort();
    }
    return 0;
}
