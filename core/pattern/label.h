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

/// Where a block of text goes and how high its capital letters are, mm.
struct LabelPlace {
    Eigen::Vector2d position;  ///< middle of the first line
    double height;
};

/// Width and height of a block of centred lines whose capitals are `height` high, by an average
/// character; never empty.
Eigen::Vector2d textExtent(const std::vector<std::string>& lines, double height);

/// Finds room for horizontal lines of text on the cloth of a piece, concave or narrow ones too: the
/// largest height from 6 mm down to 1.5 mm for which the block fits, in the middle of the room that
/// is nearest to the outline's middle. Where even the smallest does not fit it is centred on the
/// outline's widest chord.
/// @param loops  mm, the outline, then holes; closed, first point not repeated; either winding
/// Cost: 41 passes over the loops per height tried. Linear but for edges met that are few beside
/// the width in letters: these are sorted.
LabelPlace placeLabel(const std::vector<Points2>& loops, const std::vector<std::string>& lines);

}  // namespace toile
