// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// Characters that follow each other in one font, one script and one direction.
struct TextRun {
    std::u32string characters{};  ///< as they are read
    std::size_t font = 0;
    std::uint32_t script = 0;  ///< as HarfBuzz numbers them
    bool isRightToLeft = false;
};

/// The runs of a line from its left to its right. Directions by the main rules of Unicode: the
/// first letter gives that of the line, letters their own, numbers run to the right, and what lies
/// between goes with its neighbours where these agree, else with the line; marks that turn the
/// direction are taken for blanks.
/// @param line    UTF-8
/// @param fontOf  a character's font; accents and joiners stay in that of what stands before them
/// Cost: linear. Pure.
std::vector<TextRun> textRuns(std::string_view line,
                              const std::function<std::size_t(char32_t)>& fontOf);

}  // namespace toile
