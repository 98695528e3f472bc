// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// From one baseline of a text to the next, in heights of a capital letter.
inline constexpr double kLineSpacing = 1.7;
/// Width of a character, in heights of a capital letter: a fair average of usual fonts.
inline constexpr double kCharacterWidth = 0.8;

/// Heights of the capitals of a label, mm.
inline constexpr double kLargestLabel = 10, kSmallestLabel = 1.5;

/// Where a block of text goes and how high its capital letters are, mm.
struct LabelPlace {
    Eigen::Vector2d position;  ///< middle of the first line
    double height;
    bool fits = true;  ///< false: even the smallest has no room there
};

/// Width and height of a block of centred lines whose capitals are `height` high, by an average
/// character; never empty.
Eigen::Vector2d textExtent(const std::vector<std::string>& lines, double height);

/// The same words in a narrower block: lines that are longer than the longest must be are broken in
/// two at a blank.
std::vector<std::string> brokenLines(const std::vector<std::string>& lines);

/// The box of such a block as a closed line that ends where it begins: 5 x 2.
/// @param angle  of the lines about the place, radians  @param clear  mm to either side
Points2 textBox(const LabelPlace& place, const std::vector<std::string>& lines, double angle,
                double clear);

/// Finds room for horizontal lines of text on the cloth of a piece, concave or narrow ones too: the
/// block is as large as fits anywhere, but for 6 % and up to kLargestLabel, with half a capital of
/// air around it, at the pole of a box of its proportions (`boxPole`), of equals nearest to the
/// middle. Where even the smallest does not fit it stands there all the same.
/// @param loops      mm, the outline, then holes; closed, first point not repeated; either winding
/// @param obstacles  what it must keep off (`FreeCloth`)
/// Cost: that of boxPole. Pure.
LabelPlace placeLabel(const std::vector<Points2>& loops, const std::vector<std::string>& lines,
                      const std::vector<Points2>& obstacles = {});

}  // namespace toile
