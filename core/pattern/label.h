// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// From one baseline of a text to the next, in heights of a capital letter.
inline constexpr double kLineSpacing = 1.7;
/// Width of a character, in heights of a capital letter: average of common fonts.
inline constexpr double kCharacterWidth = 0.8;

/// Heights of the capitals of a label, mm.
inline constexpr double kLargestLabel = 10, kSmallestLabel = 1.5;

/// Position of a block of text and the height of its capital letters, mm.
struct LabelPlace {
    Eigen::Vector2d position;  ///< middle of the first line
    double height;
    bool fits = true;  ///< false: there is no room even for the smallest
};

/// Width and height of a block of centred lines with capitals of this height, by an average
/// character; never empty.
Eigen::Vector2d textExtent(const std::vector<std::string>& lines, double height);

/// The same words in a narrower block: lines longer than the least possible block width are broken
/// at a blank.
std::vector<std::string> brokenLines(const std::vector<std::string>& lines);

/// The box of such a block as a closed line (first point repeated): 5 x 2.
/// @param angle  of the lines about the place, radians  @param clear  margin on either side, mm
Points2 textBox(const LabelPlace& place, const std::vector<std::string>& lines, double angle,
                double clear);

/// Finds room for horizontal lines of text on the cloth of a piece, even concave or narrow: the
/// block is within 6 % of the largest size that fits, up to kLargestLabel, with half a capital of
/// margin, at the pole of a box of its proportions (`boxPole`); of equals nearest to the middle. If
/// even the smallest does not fit, it is placed there anyway.
/// @param loops      mm, the outline, then holes; closed, first point not repeated; either winding
/// @param obstacles  lines to keep clear of (`FreeCloth`)
/// Cost: that of boxPole. Pure.
LabelPlace placeLabel(const std::vector<Points2>& loops, const std::vector<std::string>& lines,
                      const std::vector<Points2>& obstacles = {});

}  // namespace toile
