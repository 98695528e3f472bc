// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace toile::fuzz {

/// What one fuzz target does with the fuzzer's bytes, and the folder of `seeds` it starts from.
struct Target {
    const char* name;
    /// @return the first promise that is broken, in words; empty where all are kept, which includes
    ///         every refusal that gives its reason
    std::string (*whatBreaks)(std::string bytes);
};

/// One per reader, and "garment": the whole pipeline.
std::span<const Target> targets();

}  // namespace toile::fuzz
