// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace toile {

/// Deeper than any file of ours. The JSON library copies values by recursion where an object grows,
/// so that a text of brackets alone would use the stack up.
inline constexpr int kMostJsonDepth = 64;

/// How deep lists and objects lie in each other; of a text that is no JSON, any number. Linear.
/// Pure.
int jsonDepth(std::string_view text);

}  // namespace toile
