// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::fuzz {

/// Lines of requests in memory, done to a small garment by one session of `toile serve`. What would
/// read or write files of the fuzzer's naming is only parsed, as is what takes long by its options.
/// @return the first promise that is broken, in words; empty where all are kept: one line of JSON
///         for each, with the id that was read and a result, or a code and a sentence; and nothing
///         that is refused changes the garment
/// Cost: that of what is asked for. Re-entrant.
std::string whatBreaksInServe(std::string bytes);

}  // namespace toile::fuzz
