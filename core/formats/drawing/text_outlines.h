// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/drawing/drawing.h"
#include "core/pattern/curve_fit.h"

namespace toile {

/// Consecutive characters with the same font, script and direction.
struct TextRun {
    std::u32string characters{};  ///< in reading order
    std::size_t font = 0;
    std::uint32_t script = 0;  ///< HarfBuzz number
    bool isRightToLeft = false;
};

/// The runs of a line from left to right. Directions follow the main rules of Unicode: the first
/// letter sets that of the line, letters have their own, numbers run to the right, and characters
/// between take the direction of their neighbours if these agree, else that of the line; marks that
/// change the direction are treated as blanks.
/// @param line    UTF-8
/// @param fontOf  font of a character; accents and joiners keep the font of the preceding character
/// Cost: linear. Pure.
std::vector<TextRun> textRuns(std::string_view line,
                              const std::function<std::size_t(char32_t)>& fontOf);

/// A line of text as the outlines of its letters: y up, from (0, 0) on the baseline to the right.
struct TextOutlines {
    std::vector<std::vector<CubicCurve>> contours;  ///< closed; filled by the non-zero winding rule
    double width = 0;                               ///< of the whole line
};

/// In DejaVu Sans; system fonts supply the letters that it lacks, in any script.
/// @param line    UTF-8  @param height  of a capital letter, in the unit of the outlines Without
/// any font: no contours, and the width of `textExtent`. Thread-safe.
TextOutlines textOutlines(std::string_view line, double height);

/// The outlines of a text (`textOutlines`) placed in the drawing, mm, y up; none without fonts.
std::vector<std::vector<CubicCurve>> placedOutlines(const DrawnText& text);

}  // namespace toile
