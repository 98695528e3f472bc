// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/pattern/cubic_curve.h"

namespace toile {

/// A line of text as the outlines of its letters: y up, from (0, 0) on the baseline to the right.
struct TextOutlines {
    std::vector<std::vector<CubicCurve>> contours;  ///< closed; filled by the non-zero winding rule
    double width = 0;                               ///< of the whole line
};

/// In DejaVu Sans; system fonts supply the letters that it lacks, in any script.
/// @param line    UTF-8  @param height  of a capital letter, in the unit of the outlines Without
/// any font: no contours, and the width of `textExtent`. Thread-safe.
TextOutlines textOutlines(std::string_view line, double height);

}  // namespace toile
