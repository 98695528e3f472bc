// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Fits one closed line onto another without known correspondences.

/// The best rigid motion found that fits a line onto another: a rotation and translation, after a
/// mirroring if allowed.
struct LineFit {
    Points2 laid = Points2(0, 2);  ///< the second line after the motion
    bool mirrored = false;
    double mean = 0;      ///< mm, of the distances of both lines' points from the other line
    double farthest = 0;  ///< mm, the largest of them
    double rms = 0;       ///< mm, root mean square of them
};

/// A rough distance of two closed lines, for sorting: root mean square distance, mm, of points at
/// equal fractions of the lengths, with the best start point and rigid motion. Infinite if a line
/// has fewer than three points or no length.
/// Cost: constant, some 30 thousand steps. Pure.
double roughDistance(const Points2& line, const Points2& other, bool mirrored);

/// Starts like `roughDistance`, then refines by iterative closest points. Uses the mirrored fit
/// only if it is clearly better. Resamples lines of more than 20 000 points at equal distances.
/// @param canMirror  whether mirroring is allowed
/// Cost: up to forty rounds per fit, of n log n in the points of both lines. Pure.
LineFit fitLine(const Points2& line, const Points2& other, bool canMirror = true);

}  // namespace toile
