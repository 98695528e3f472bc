// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// How one closed line is laid over another when nobody says which points belong together.

/// A line laid over another by the best motion found: turned, moved and, where asked for, first
/// mirrored.
struct LineFit {
    Points2 laid = Points2(0, 2);  ///< the second line, where it then lies
    bool mirrored = false;
    double mean = 0;      ///< mm, of the distances of both lines' points along them from the other
    double farthest = 0;  ///< mm, the largest of them
    double rms = 0;       ///< mm, root mean square of them
};

/// A rough distance of two closed lines, for sorting: points at even shares of their lengths, from
/// the start and by the motion with which these come nearest to each other. mm, root mean square;
/// infinite where a line has fewer than three points or no length.
/// Cost: constant, some 30 thousand steps. Pure.
double roughDistance(const Points2& line, const Points2& other, bool mirrored);

/// Starts as `roughDistance` does and then lets the nearest points pull, mirrored or not as fits
/// better; a mirrored fit must be clearly better.
/// Of more than 20 000 points these lie at even distances.
/// @param canMirror  whether it may be mirrored
/// Cost: some forty rounds of n log n in the points of both lines. Pure.
LineFit fitLine(const Points2& line, const Points2& other, bool canMirror = true);

}  // namespace toile
